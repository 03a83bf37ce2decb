(** Regions as sets of points of a convex solid: which points belong to them, and along which planes the solid
    is cut. After the cut each region is a union of features of the pieces. *)

open Scc_base
open Scc_exact
open Scc_geometry

(** The curved solid that the polyhedron replaces; caps refer to it. *)
type round =
  | Flat  (** none *)
  | Ball
  | About_axis  (** a cylinder or cone about the z axis: its faces but for [top] and [bottom] *)

(** A convex solid with its constants and regions. *)
type solid

val solid : plain:Plain.t -> declared:(string -> Region.t option) -> round -> Polyhedron.t -> solid
(** [solid ~plain ~declared round p] is the solid [p] with the constants of the text and the regions of the
    solid by their names. *)

(** A region whose names and places are resolved. *)
type t

val most_parts : int
(** The greatest number of regions in one region, with those behind names: 1 000. *)

val resolve : solid -> Region.t -> t
(** Finds the features, places and other regions of a region.

    Raises {!Fault.Found}. SC0203: no such feature. SC0360: sides of a polygon that cross, a cap of a solid that
    is not curved, or the interior of a region that is no feature. SC0361: not on the surface. SC0362:
    coordinates that are no plain numbers. SC0111: more than {!most_parts}.

    [cap(v, c)], for 0 <= c < 1, consists of the whole facets all of whose vertices x have v.x >= c |v| |x|.
    About an axis, x and v are both without their z, and x is off the axis.

    For a ball, these points form the cone about v that cuts the cap out of the sphere. The cone is convex, so
    it contains the whole of such a facet. So the facets lie on the rays from the centre to points of the cap:
    seen from the centre, they are within it. *)

val planes : solid -> t -> Pieces.plane list
(** The planes of a region. If the solid is cut along them, and along any others besides, each open feature on
    the surface is wholly inside the region or wholly outside. *)

val contains : solid -> t -> Vec.t -> bool
(** [contains s r x] is true if the region [r] contains the point [x], which must be on the surface. *)

val on_surface : solid -> Vec.t -> bool
(** [on_surface s x] is true if the point [x] of the solid is on its surface. *)

val not_plain : Span.t -> 'a
(** Raises {!Fault.Found} with SC0362: a plain number is missing at this place. *)

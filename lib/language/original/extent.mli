(** Regions as sets of points of a convex solid: which points they have, and along which planes the solid is to
    be cut so that each region is a union of features of the pieces. *)

open Scc_base
open Scc_exact
open Scc_geometry

(** What the solid stands for, so that a cap has a meaning. *)
type round =
  | Flat  (** itself *)
  | Ball
  | About_axis  (** a cylinder or cone about the z axis: its faces but for [top] and [bottom] *)

type solid

val solid : plain:Plain.t -> declared:(string -> Region.t option) -> round -> Polyhedron.t -> solid
(** With the constants of the text, and the regions of the solid by their names. *)

type t

val most_parts : int
(** A region is made of 1 000 others at most, however they are named. *)

val resolve : solid -> Region.t -> t
(** Raises {!Fault.Found}: SC0203 (no such feature), SC0360 (sides of a polygon that cross, a cap of what is not
    curved, the interior of what is no feature), SC0361 (not on the surface), SC0362 (coordinates that are no
    plain numbers), SC0111
    (more than {!most_parts}).

    [cap(v, c)], for 0 <= c < 1, consists of the whole facets all of whose vertices x have v.x >= c |v| |x|
    (about an axis: of x and v both without their z, where x is off the axis). For a ball that is the cone about
    v of which the cap of the sphere is what the sphere has in common with it; it is convex, and so has the
    whole of such a facet. So the facets are on the rays from the centre to points of the cap: within it, seen
    from the centre. *)

val planes : solid -> t -> Pieces.plane list
(** Cut along these, and any others besides, each open feature on the surface is in the region or outside it as
    a whole. *)

val contains : solid -> t -> Vec.t -> bool
(** Of a point of the surface. *)

val on_surface : solid -> Vec.t -> bool
(** Of a point of the solid. *)

val not_plain : Span.t -> 'a
(** Raises SC0362. *)

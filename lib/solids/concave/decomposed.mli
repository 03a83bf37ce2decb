(** A drawn solid, from its set of faces to its convex parts. *)

open Scc_geometry

type fault =
  | Unsound of Sound.fault
  | Pieces of Shells.fault  (** not one solid *)
  | Too_many  (** more parts than the limit, or too long a way to them *)

val message : Polyhedron.ifs -> fault -> Scc_base.Code.t * string
(** Of one that is about more than single faces; {!Polyhedron_fault} has the words for [Structure] (a bug here). *)

val surface : Polyhedron.ifs -> (Drawn.t, fault) result
(** Of one solid: its faces are sound ({!Sound}), and it is in one piece ({!Shells}). Fails with no [Too_many]. *)

(** How far it is: what was done last. *)
type progress =
  | Looking of int  (** at so many faces *)
  | Cutting of int  (** cells, and pairs of them, that were looked at *)
  | Making of int * int  (** parts of so many *)
  | Naming of int  (** the faces of parts; so many parts are left *)

val parts : ?progress:(progress -> unit) -> Polyhedron.ifs -> (Polyhedron.t list * Drawn.t, fault) result
(** Disjoint convex polyhedra of which the solid is the union. A prism over a polygon has the parts of
    {!Scc_polygon.Prism}, any other solid those of {!Scc_decompose.Decompose}. Each is joined to the others by
    faces. *)

val make : ?progress:(progress -> unit) -> Polyhedron.ifs -> (Parts.t, fault) result
(** The same, cut further so that names of the solid's faces are exact, and with these names. What is called for
    [progress], again and again, may raise. *)

val limit : int
(** 10 000 parts. *)

(** A drawn solid, from its set of faces to its convex parts. *)

open Scc_geometry

type fault =
  | Unsound of Sound.fault
  | Separate  (** solids that have no face in common, or a hollow that is turned the wrong way *)
  | Too_many  (** more parts than the limit, or too long a way to them *)

val message : Polyhedron.ifs -> fault -> Scc_base.Code.t * string
(** Of one that is about more than single faces; {!Polyhedron_fault} has the words for [Structure] (a bug here). *)

val parts : Polyhedron.ifs -> (Polyhedron.t list * Drawn.t, fault) result
(** Disjoint convex polyhedra of which the solid is the union. A prism over a polygon has the parts of
    {!Scc_polygon.Prism}, any other solid those of {!Scc_decompose.Decompose}. Each is joined to the others by
    faces. *)

val make : Polyhedron.ifs -> (Parts.t, fault) result
(** The same, cut further so that names of the solid's faces are exact, and with these names. *)

val limit : int
(** 10 000 parts. *)

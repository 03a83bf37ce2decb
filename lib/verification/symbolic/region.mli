(** Regions of a zone: cut by constraints. *)

open Scc_polyhedra

val where : Polyhedron.t -> Constraint.t list -> Polyhedron.t list
(** Where the constraints hold: one region, or none. *)

val split : Polyhedron.t -> Constraint.t list -> Polyhedron.t option * Polyhedron.t list
(** Where the constraints hold, if they do somewhere, and disjoint pieces of where they do not; none is empty. *)

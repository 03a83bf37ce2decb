(** Volumes, exactly. *)

open Scc_exact

val of_polyhedron : Polyhedron.t -> Rat.t option
(** In the units of the space, of whatever dimension: a length, an area, ...; 1 for the point of the space of
    dimension 0. It is 0 if the polyhedron has a smaller dimension than the space, and [None] if it is infinite.
    By facets: J. Lasserre, {e An
    analytical expression and an algorithm for the volume of a convex polyhedron in R{^n}} (1983). *)

val of_union : Union.t -> Rat.t option
(** What pieces have in common counts once. *)

(** Volumes, exactly. *)

open Scc_exact

type t =
  | Finite of Rat.t  (** in the units of the space, of whatever dimension: a length, an area, ... *)
  | Infinite
  | Not_computed  (** there is one, but it would take too long: more than {!most_corners} *)

val most_corners : int
(** How many corners are looked at of variables that constraints join: of ten in a box that a plane cuts, there
    are some thousand; each variable more makes them about twice as many. *)

val of_polyhedron : Polyhedron.t -> t
(** 1 for the point of the space of dimension 0; 0 if the polyhedron has a smaller dimension than the space. By
    corners: J. Lawrence, {e Polytope volume computation} (1991). Variables that no constraint joins are a matter
    each of its own, and their volumes are multiplied. *)

val sum : t list -> t

val of_union : Union.t -> t
(** What pieces have in common counts once. *)

(** Volumes, exactly. *)

open Scc_exact

type t =
  | Finite of Rat.t  (** in the units of the space, of whatever dimension: a length, an area, ... *)
  | Infinite
  | Not_computed  (** the volume is finite, but there are more corners than {!most_corners} *)

val most_corners : int
(** The greatest number of corners that are considered for variables that constraints join: 20 000. A box of
    ten variables that a plane cuts has some thousand corners; each further variable doubles them about. *)

val of_polyhedron : Polyhedron.t -> t
(** The volume of a polyhedron, by its corners: J. Lawrence, {e Polytope volume computation} (1991). The only
    point of the space of dimension 0 has volume 1. A polyhedron of a smaller dimension than its space has
    volume 0. Blocks of variables that no constraint joins are computed separately, and their volumes are
    multiplied. *)

val sum : t list -> t
(** The sum of volumes. [Infinite] if one of them is infinite, else [Not_computed] if one of them is. *)

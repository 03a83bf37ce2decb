(** Numbers of rigid models for people: those that turns have made long are told as decimals. *)

open Scc_exact
open Scc_calculus

val rat : Rat.t -> string
(** Exact up to 24 characters, else ["~"] and six decimal places. *)

val position : Model.t -> State.leaf -> string
(** ["(1, 2, 3)"], and how the leaf is turned, if it is: ["(1, 2, 3) turned (2, 0, 0, 1)"], a quaternion w, x, y,
    z. Always exact in a translational model. *)

val motion : Model.t -> State.process -> string
(** ["velocity (1, 0, 0)"], and the spin, if there is one: ["velocity (1, 0, 0), spin (0, 0, 1)"]. Always exact in
    a translational model. *)

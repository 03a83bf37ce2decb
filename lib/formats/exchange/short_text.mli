(** Numbers for people: long ones are told as decimals, in rigid models sooner than in others. *)

open Scc_exact
open Scc_calculus

val rat : Rat.t -> string
(** Exact up to 24 characters, else {!Decimal.marked}. *)

val exact : Rat.t -> string
(** Exact up to 60 characters, and fractions of more than 15 with a decimal beside: ["137174210/109739369
    (~1.250000)"], by {!Decimal.marked}. Else that alone, and how many characters it would take. *)

val within : string -> string
(** A text in which each number is written so. *)

val position : ?full:bool -> Model.t -> State.leaf -> string
(** ["(1, 2, 3)"], and how the leaf is turned, if it is: ["(1, 2, 3) turned (2, 0, 0, 1)"], a quaternion w, x, y,
    z. In a translational model numbers are {!exact}; all have all their digits if [full]. *)

val motion : ?full:bool -> Model.t -> State.process -> string
(** ["velocity (1, 0, 0)"], and the spin, if there is one: ["velocity (1, 0, 0), spin (0, 0, 1)"]. In a
    translational model numbers are {!exact}. *)

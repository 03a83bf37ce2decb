(** Numbers in texts for readers. Long numbers become decimals, in rigid models sooner than in others. *)

open Scc_exact
open Scc_calculus

val exact : Rat.t -> string
(** The number, exact up to 60 characters. A fraction of more than 15 characters also has a decimal by
    [Decimal.marked]: ["137174210/109739369 (~1.250000)"]. Beyond 60 there is the decimal alone, with the
    number of characters of the exact number. *)

val within : string -> string
(** A text in which each number is written as by {!exact}. *)

val position : ?full:bool -> Model.t -> State.leaf -> string
(** The position of a leaf, such as ["(1, 2, 3)"]. A turned leaf also has a quaternion w, x, y, z:
    ["(1, 2, 3) turned (2, 0, 0, 1)"]. In a translational model numbers are {!exact}. All have all their digits
    if [full]. *)

val motion : ?full:bool -> Model.t -> State.process -> string
(** The velocity of a process, such as ["velocity (1, 0, 0)"], and its spin if it has one:
    ["velocity (1, 0, 0), spin (0, 0, 1)"]. Numbers are as in {!position}. *)

val bond : Model.t -> State.bond -> string
(** A bond by its channel and its two sites: ["<a, {p.top, q.bottom}>"]. *)

(** Values of parameters to be gone through, each with each. *)

open Scc_exact

type axis = { name : string; values : Rat.t array  (** one or more *) }
type t = axis list

val most : int
(** Of points, and of the values of one axis: a million. *)

val values : string -> (Rat.t array, string) result
(** Of ["3"], ["1/2, 1, 5"], ["1..10"] (integers, or by steps of 1 from the first) or ["0:2:1/8"] (from, to, step).
    What is wrong otherwise. *)

val size : t -> Z.t
(** How many points. *)

val point : t -> int -> (string * Rat.t) list
(** From 0 on, the last axis goes fastest. *)

val place : t -> int -> int list
(** The same by the number of the value on each axis. *)

(** Tables of rationals, numbered in the order of insertion; the rational 0 has the number 0. *)

open Scc_exact

type t

val create : unit -> t
(** [create ()] is a table with the rational 0. *)

val intern : t -> Rat.t -> int
(** [intern t x] is the number of [x], which is inserted if it is new. Equal rationals have equal numbers. *)

val get : t -> int -> Rat.t
(** [get t n] is the rational with number [n], which must exist (a bug otherwise). *)

val size : t -> int
(** [size t] is the number of rationals in the table. *)

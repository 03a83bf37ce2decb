(** Rationals, each numbered when it is first seen; 0 has the number 0. *)

open Scc_exact

type t

val create : unit -> t
val intern : t -> Rat.t -> int
val get : t -> int -> Rat.t

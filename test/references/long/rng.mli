(** A generator of our own (SplitMix64), so that a seed names the same cases everywhere. A state is used by one
    group of cases only. *)

open Scc_exact

type t

val make : int list -> t
(** Independent streams for different lists. *)

val below : t -> int -> int
(** From 0 to n - 1. *)

val range : t -> int -> int -> int
(** Both ends included. *)

val chance : t -> int -> bool
(** [chance g n]: once in [n] times. *)

val choose : t -> 'a array -> 'a
val positive : t -> int -> Z.t
(** [positive g k] is from 1 to 2^k. *)

val fraction : t -> int -> Rat.t
(** [fraction g n] is in (-1, 1), with a denominator from 2 to [n] before it is reduced. *)

val vector : t -> int -> Vec.t
(** Of integers from -n to n, not zero. *)

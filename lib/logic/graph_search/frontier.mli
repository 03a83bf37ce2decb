(** States that wait to be expanded, in one of two orders. *)

open Scc_exact

type t

val by_steps : unit -> t
(** As they came in. *)

val by_time : unit -> t
(** By their times, then as they came in. *)

val push : t -> int -> Rat.t -> unit

val take : t -> int option
(** The one at the head leaves. *)

val length : t -> int
val iter : (int -> unit) -> t -> unit

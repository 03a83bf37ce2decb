(** Arrays that grow at the end. *)

type 'a t

val create : unit -> 'a t
val length : 'a t -> int

val get : 'a t -> int -> 'a
(** The index is in range (a bug otherwise). *)

val push : 'a t -> 'a -> unit

val set : 'a t -> int -> 'a -> unit

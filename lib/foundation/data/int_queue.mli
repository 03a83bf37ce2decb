(** First in, first out: numbers, 8 bytes each. *)

type t

val create : unit -> t
val length : t -> int
val push : t -> int -> unit
val take : t -> int option

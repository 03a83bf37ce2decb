(** Growing vectors of small integers in few bytes: 4 for each, 2 where neighbours are near each other, and next to
    nothing where they are equal. *)

type t

val create : unit -> t
val length : t -> int

val get : t -> int -> int
(** The index is in range (a bug otherwise). *)

val push : t -> int -> unit
(** A number in [-2{^31}, 2{^31}) (a bug otherwise). *)

val set : t -> int -> int -> unit

val bytes : t -> int
(** About how much memory it takes. *)

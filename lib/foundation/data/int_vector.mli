(** Growing vectors of small integers in few bytes: 4 for each, 2 where neighbours are near each other, and next to
    nothing where they are equal. *)

type t

val create : unit -> t
(** [create ()] is a new empty vector. *)

val length : t -> int
(** [length v] is the number of elements. *)

val get : t -> int -> int
(** [get v i] is element [i], from 0. The index is in range (a bug otherwise). *)

val push : t -> int -> unit
(** [push v x] appends [x], a number at least -2{^31} and below 2{^31} (a bug otherwise). *)

val set : t -> int -> int -> unit
(** [set v i x] replaces element [i]. The index is in range, and [x] is as for {!push}. *)

val bytes : t -> int
(** [bytes v] is about how much memory the vector takes, in bytes. *)

(** Arrays that grow at the end, in amortised constant time. *)

type 'a t

val create : unit -> 'a t
(** [create ()] is a new empty array. *)

val length : 'a t -> int
(** [length a] is the number of elements. *)

val get : 'a t -> int -> 'a
(** [get a i] is element [i], from 0. The index is in range (a bug otherwise). *)

val push : 'a t -> 'a -> unit
(** [push a x] appends [x]. *)

val set : 'a t -> int -> 'a -> unit
(** [set a i x] replaces element [i]. The index is in range (a bug otherwise). *)

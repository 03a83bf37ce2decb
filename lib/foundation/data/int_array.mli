(** Arrays of small integers, four bytes each: graphs of 10^7 edges live in these, outside of the heap that
    the collector walks. *)

type t

val max_value : int
(** 2^31 - 1: the greatest value. Values are from -2^31 to this. *)

val make : int -> int -> t
(** [make n x]: n times [x]. *)

val length : t -> int
val get : t -> int -> int
val set : t -> int -> int -> unit

val unsafe_get : t -> int -> int
(** Without a look at the index: for the innermost loops, over indices that were made to be right. *)

val fill : t -> int -> unit

val prefix : t -> int -> t
(** The first so many, sharing their place with the array. *)

(** {1 Growing}

    In one piece, twice as long when it is full: quicker than {!Int_vector}, which takes less memory and never
    moves. *)

type buffer

val buffer : unit -> buffer
val size : buffer -> int
val nth : buffer -> int -> int
val put : buffer -> int -> int -> unit
(** Changes what was pushed. *)

val push : buffer -> int -> unit

val pop : buffer -> int
(** The last one, taken off. The buffer is not empty. *)

val clear : buffer -> unit

val contents : buffer -> t
(** What was pushed so far; a copy. *)

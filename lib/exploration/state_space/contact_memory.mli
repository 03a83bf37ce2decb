(** A memory of when two processes that move relative to each other come into contact, by the number of the pair.
    It grows up to a bound, and then forgets. *)

open Scc_exact

type t

val create : most:int -> t
(** At most so many pairs, a power of two. *)

(** What is known of a pair, in one number, so that most questions take one access to memory. *)
type code = private int

val find : t -> int -> code
val unknown : code
val never : code

val meeting : code
(** They collide now. *)

val is_exact : code -> bool
(** Whether the time is known, and not only that it is not before some time; of neither of the above. *)

val rank : code -> int
(** Of the time, or of the one before which it is not: a later time never has a lesser rank. *)

val rank_of : Rat.t -> int
(** Of a time of at least 0. *)

val time : t -> int -> Rat.t
(** Of a pair for which {!find} has just given a code that {!is_exact}. *)

val keep_never : t -> int -> unit
val keep_meeting : t -> int -> unit

val keep_time : t -> int -> Rat.t -> unit
(** At least 0. *)

val keep_not_before : t -> int -> float -> unit
(** Likewise; not infinite. *)

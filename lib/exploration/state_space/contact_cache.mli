(** A cache of the times at which two processes in relative motion come into contact, by the number of the pair.
    It grows up to a bound; then new pairs replace old ones. *)

open Scc_exact

type t

val create : most:int -> t
(** An empty cache for at most [most] pairs, a power of two. *)

(** The knowledge about a pair, in one number, so that most queries take one access to memory. *)
type code = private int

val find : t -> int -> code
(** The code of a pair, by its number; {!unknown} if it is not in the cache. *)

val unknown : code
(** Nothing is known of the pair. *)

val never : code
(** The two never come into contact. *)

val meeting : code
(** The two collide now. *)

val is_exact : code -> bool
(** [is_exact code] is true if the time of contact is known, and false if only a lower bound of it is. It is for
    codes of {!keep_time} and {!keep_not_before}. *)

val rank : code -> int
(** The rank of the time of contact, or of its lower bound. Ranks are monotone: a later time never has a lesser
    rank. *)

val rank_of : Rat.t -> int
(** The rank of a time >= 0. *)

val time : t -> int -> Rat.t
(** The time of contact of a pair for which {!find} has just given a code that {!is_exact}. *)

val keep_never : t -> int -> unit
(** Records that the pair never comes into contact. *)

val keep_meeting : t -> int -> unit
(** Records that the pair collides now. *)

val keep_time : t -> int -> Rat.t -> unit
(** Records the time of contact of the pair, which is at least 0. *)

val keep_not_before : t -> int -> float -> unit
(** Records a lower bound of the time of contact of the pair. It is at least 0 and finite. *)

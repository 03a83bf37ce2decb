(** A set of which only fingerprints of 30 bits are kept: 5 to 11 bytes for each member. A new member whose
    fingerprint is that of another near by is taken for known (hash compaction: Wolper and Leroy, Reliable
    Hashing without Collision Detection, 1993). *)

type t

val create : capacity:int -> t
(** For at most so many members. *)

val add : t -> int -> bool
(** Whether a number was not known, as far as can be told; it is from then on. *)

val omission : t -> float
(** A bound on the probability that some new member has been taken for known so far, if the hash function tells
    numbers apart like a random one: what is new is taken for known with at most the number of fingerprints that
    it is compared with, over 2{^30}. All comparisons count: those that found nothing might have, and of those
    that did nobody knows whether the member was new. *)

val bytes : t -> int

(** Sets that store only fingerprints of 30 bits: 5 to 11 bytes for each member. A new member is taken for a known
    one if an equal fingerprint stands near its place (hash compaction: Wolper and Leroy, Reliable Hashing without
    Collision Detection, 1993). *)

type t

val create : capacity:int -> t
(** [create ~capacity] is an empty set for at most [capacity] members. *)

val add : t -> int -> bool
(** [add s x] inserts [x], and is true if [x] seemed to be new. A set beyond its capacity is a bug. *)

val omission : t -> float
(** [omission s] is a bound on the probability that some new member has been taken for known so far, if the hash
    function behaves as a random one. A new member is taken for known with a probability of at most n/2{^30}, where
    n is the number of fingerprints that it is compared with. All comparisons count: those without a match could
    have matched, and a match may have been a new member. *)

val bytes : t -> int
(** [bytes s] is the size of the table, in bytes. *)

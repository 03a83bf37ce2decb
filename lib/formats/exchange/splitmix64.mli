(** SplitMix64, the generator of Steele, Lea and Flood (2014): 64 bits of state, the same numbers on every
    machine and with every compiler (the generator of the standard library differs between versions). *)

type t

val of_seed : int64 -> t

val next : t -> int64 * t
(** state := state + 0x9E3779B97F4A7C15; the result is the state mixed:
    z := (z xor z>>30) * 0xBF58476D1CE4E5B9; z := (z xor z>>27) * 0x94D049BB133111EB; z xor z>>31. *)

val below : int -> t -> int * t
(** [below n g] is a number in [0, n) for n > 0: the remainder by n of the first output that is below the
    greatest multiple of n in 2^63, taken without its lowest bit; so that all are equally likely. *)

val below_integer : Z.t -> t -> Z.t * t
(** [below_integer n g] is an integer in [0, n) for n > 0, all equally likely: the highest bits, as many as n - 1
    has, of as few outputs as have so many, one after the other; drawn again while that is not less than n. *)

val by_chance : Scc_exact.Rat.t list -> t -> int * t
(** A place in a list of chances, which are positive, each with the share that it has in their sum, exactly. *)

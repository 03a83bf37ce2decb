(** SplitMix64, the generator of Steele, Lea and Flood (2014), with 64 bits of state. It gives the same numbers
    on every machine and with every compiler, unlike the generator of the standard library, which differs
    between versions. *)

(** The state of a generator. *)
type t

val of_seed : int64 -> t
(** The generator whose state is the seed. *)

val next : t -> int64 * t
(** The next 64 bits, and the generator after them.

    state := state + 0x9E3779B97F4A7C15; the result is the state mixed: z := (z xor z>>30) * 0xBF58476D1CE4E5B9;
    z := (z xor z>>27) * 0x94D049BB133111EB; z xor z>>31. *)

val below : int -> t -> int * t
(** [below n g] is a number from 0 to n - 1, for n > 0, each equally likely. It is the remainder by n of the
    first output (without its lowest bit) that is below the greatest multiple of n in 2^63. *)

val by_chance : Scc_exact.Rat.t array -> t -> int * t
(** [by_chance chances g] is an index into the array of positive chances. Each is drawn with exactly its share of
    the sum. *)

(** Upper bounds of tails of the binomial distribution. Numbers have 192 binary digits, and every operation is
    rounded up. *)

open Scc_exact

type coefficient
(** The binomial coefficient of n and k, computed once for all chances. *)

val coefficient : n:int -> k:int -> coefficient
(** [coefficient ~n ~k] is the binomial coefficient, rounded up, for 0 <= k <= n. *)

val at_most : coefficient -> chance:Rat.t -> Rat.t -> bool
(** [at_most c ~chance limit] is true if this is proved: [n] trials, each of which succeeds with the probability
    [chance], have at least [k] successes with a probability of at most [limit]. [chance] is from 0 to 1, and
    [limit] is less than 1/2. *)

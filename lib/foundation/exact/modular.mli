(** Polynomials in one variable modulo a prime below 2{^31}: coefficients from the constant one up, from 0 to p -
    1, the last one not 0. *)

type t = int array

val first_prime : int
(** The greatest prime below 2{^31}. *)

val prime_below : int -> int
(** [prime_below n] is the greatest prime that is less than [n], for 3 < n <= 2{^31}. *)

val reduce : int -> Rat.t -> int option
(** [reduce p x] is [x] modulo the prime [p]; [None] if [p] divides its denominator. *)

val coprime : Z.t array -> Z.t array -> bool
(** [coprime a b] is true if a prime proves that two polynomials with these integer coefficients have no common
    root, real or complex. The last coefficients are not 0. They may have none where it is false. *)

val fraction : int -> at:int array -> values:int array -> (t * t) option
(** [fraction p ~at ~values] is polynomials n and d without a common root such that n(x) = y d(x) and d(x) <> 0
    modulo [p] for each point x of [at], which differ, and its value y. The leading coefficient of d is 1. Their
    degrees have a sum of at most the number of points minus 3. [None] if there is no such pair; if there are
    several, it is the first one of Euclid's scheme. *)

(** A rational function of low degree through given points (Cauchy's interpolation). It is computed modulo primes,
    and found from its residues by the Chinese remainder theorem (Wang, Guy and Davenport, "P-adic reconstruction
    of rational numbers", 1982). *)

val through : interrupted:(unit -> bool) -> (Rat.t * Rat.t) array -> Rational_function.t option
(** [through ~interrupted points] is a function n/d in lowest terms with f(x) = y for all points (x, y), such that
    the sum of the degrees of n and d is at most the number of points minus 3. The x differ. If both degrees are
    at most half of that, it is the only such function. The result is [None] if none was found, or if the
    computation was interrupted. *)

(** The real roots of a polynomial in an open interval with rational ends, for polynomials of high degree: by
    Bernstein coefficients ({!Bernstein}), not by Sturm chains. *)

val all : Polynomial.t -> low:Rat.t -> high:Rat.t -> Algebraic.t list
(** [all p ~low ~high] is the roots of [p] in the open interval, each once, increasing. [p] is not zero (a bug
    otherwise). *)

val changes : Polynomial.t -> low:Rat.t -> high:Rat.t -> Algebraic.t list
(** [changes p ~low ~high] is the roots at which [p] changes its sign, increasing; none for zero. *)

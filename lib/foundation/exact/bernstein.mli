(** Polynomials over an interval by their Bernstein coefficients, and the instants at which they change sign.

    A polynomial p of degree at most n over [low, high] is sum b_i C(n, i) (1 - x)^(n - i) x^i with x = (t -
    low) / (high - low). p lies between the least and the greatest b_i; b_0 and b_n are its values at the ends;
    and by the rule of Descartes it has at most as many roots in the open interval, each counted as often as it
    is multiple, as the b_i have changes of sign (zeros left out), and the difference is even. *)

type t = private {
  polynomial : Polynomial.t;
  low : Rat.t;
  high : Rat.t;  (** greater than [low] *)
  coefficients : Z.t array;  (** the b_i, up to a common positive factor; [[|0|]] for zero *)
}

val make : Polynomial.t -> low:Rat.t -> high:Rat.t -> t
(** Over an interval with low < high (a bug otherwise). *)

val halve : t -> t * t
(** The same over both halves of the interval. *)

val variations : t -> int
(** How often the coefficients change sign. *)

val sign_after_low : t -> int
(** Of the polynomial at all points of the interval that are close enough to, and greater than, its low end; 0
    for zero only. *)

val sign_before_high : t -> int

(** {1 Roots} *)

(** A real number. *)
type root = private
  | Exactly of Rat.t
  | Inside of t
  (** The only root in the open interval: it is simple, there is one change of sign, and the polynomial vanishes at
      neither end. It may be rational. *)

val rational : Rat.t -> root

val roots : Polynomial.t -> low:Rat.t -> high:Rat.t -> root list
(** The roots in the open interval (low, high), each once, increasing. The polynomial is not zero (a bug
    otherwise). *)

val low : root -> Rat.t
val high : root -> Rat.t
(** The number lies between these: strictly, unless they are equal. *)

val narrow : root -> width:Rat.t -> root
(** The same number, with bounds at most [width > 0] apart. *)

val compare : root -> root -> int

val to_algebraic : root -> scale:Rat.t -> shift:Rat.t -> Algebraic.t
(** [scale x + shift] for the number x and [scale > 0]. *)

(** {1 Changes of sign} *)

(** When a polynomial is negative first. *)
type first =
  | Nowhere
  | At_once  (** right after the start *)
  | Later of root  (** not between the start and this instant, which is later, but right after it *)

val first_negative : Polynomial.t -> after:root -> until:Rat.t -> first
(** The greatest lower bound of the t in [after, until] at which the polynomial is negative. A root at which it
    does not change sign is passed over; the zero polynomial is negative nowhere. Where [after] is a root that
    this module has found in an interval, the interval ends by [until]; the answer, which then is before
    [until], has that property too. *)

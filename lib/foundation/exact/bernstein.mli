(** Polynomials over an interval by their Bernstein coefficients, and the instants at which they change sign.

    Over [low, high], let x = (t - low) / (high - low). A polynomial p of degree at most n is
    sum b_i C(n, i) (1 - x)^(n - i) x^i. p lies between the least and the greatest b_i, and b_0 and b_n are its
    values at the ends. By the rule of Descartes, p has at most as many roots in the open interval, counted with
    multiplicity, as the b_i have changes of sign (zeros left out). The difference of the two counts is even. *)

type t = private {
  polynomial : Polynomial.t;
  low : Rat.t;
  high : Rat.t;  (** greater than [low] *)
  coefficients : Z.t array;  (** the b_i, up to a common positive factor; [[|0|]] for zero *)
}

val make : Polynomial.t -> low:Rat.t -> high:Rat.t -> t
(** [make p ~low ~high] is [p] over the interval, for [low < high] (a bug otherwise). *)

val halve : t -> t * t
(** [halve p] is the polynomial over the lower and over the upper half of the interval. *)

val variations : t -> int
(** [variations p] is the number of changes of sign of the coefficients, zeros left out. *)

(** {1 Roots} *)

(** A real number. *)
type root = private
  | Exactly of Rat.t
  | Inside of t
  (** The only root in the open interval. It is simple, the coefficients have one change of sign, and the
      polynomial vanishes at neither end. The root may be rational. *)

val rational : Rat.t -> root
(** [rational r] is the number [r]. *)

val roots : Polynomial.t -> low:Rat.t -> high:Rat.t -> root list
(** [roots p ~low ~high] is the roots of [p] in the open interval (low, high), each once, increasing. [p] is not
    zero (a bug otherwise). *)

val low : root -> Rat.t
(** [low x] is a lower bound of the number: [x] itself if it is [Exactly], and less than [x] otherwise. *)

val high : root -> Rat.t
(** [high x] is an upper bound of the number: [x] itself if it is [Exactly], and more than [x] otherwise. *)

val narrow : root -> width:Rat.t -> root
(** [narrow x ~width] is the number [x] with bounds at most [width > 0] apart. *)

val compare : root -> root -> int
(** The order of the real numbers, decided exactly. *)

val to_algebraic : root -> scale:Rat.t -> shift:Rat.t -> Algebraic.t
(** [to_algebraic x ~scale ~shift] is [scale x + shift], for [scale > 0]. *)

(** {1 Changes of sign} *)

(** The first instant at which a polynomial becomes negative. *)
type first =
  | Nowhere
  | At_once  (** right after the start *)
  | Later of root  (** right after this instant, which is later than the start, and not before it *)

val first_negative : Polynomial.t -> after:root -> until:Rat.t -> first
(** [first_negative p ~after ~until] is the infimum of the instants from [after] to [until] at which [p] is
    negative. A root without a change of sign does not count; the zero polynomial is negative nowhere. If [after]
    is an isolated root ([Inside]), its interval must end by [until]. The result lies before [until], and if it is
    isolated, its interval ends by [until] too. *)

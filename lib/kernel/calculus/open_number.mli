(** Numbers that depend on a parameter of which a range is known (rule Parametric). *)

open Scc_exact

type t = {
  parameter : Ranges.range;
  value : Rat.t;  (** for one value of the parameter, strictly within the range *)
  form : Rational_function.t;  (** for all values *)
}

val parameter : Ranges.range -> attempt:int -> t
(** [parameter range ~attempt] is the parameter itself. Its value is one of several in the range, by the number of
    the attempt from 0 on: fractions at which functions that differ have different values as a rule. *)

val attempts : int
(** The number of attempts. *)

val vanishing : Ranges.range -> Rational_function.t -> Algebraic.t option
(** [vanishing range f] is a value of the parameter strictly within the range at which [f], not constant, is 0 or
    has a pole; [None] if there is none. Then [f] has one sign on the open range. *)

val at : Ranges.range -> Algebraic.t -> string
(** [at range x] is the value [x] of the parameter as text, such as ["k = 1/2"]. *)

val narrower : Ranges.range -> string
(** [narrower range] is the hint that a narrower range of the parameter may help. *)

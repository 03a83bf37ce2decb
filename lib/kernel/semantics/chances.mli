(** The numbers in which rules Draw and Lot compute probabilities: rationals, or rationals with the functions of a
    parameter that they are (rule Parametric). *)

open Scc_exact
open Scc_calculus

type 'c t = {
  one : 'c;
  value : 'c -> Rat.t;
  add : 'c -> 'c -> 'c;
  sub : 'c -> 'c -> 'c;
  mul : 'c -> 'c -> 'c;
  div : 'c -> 'c -> 'c;
  weight : (Law.variable -> Rat.t) -> Law.expr -> ('c, Law.fault) result;  (** the value of a weight *)
  shares : step:Rat.t -> Odds.t list -> 'c list;  (** {!Odds.shares} *)
  laws :
    Kinematics.setting -> int -> Law.t ->
    (unit -> ((Given.t * 'c) list, Law.fault) result) ->
    ((Given.t * 'c) list, Law.fault) result;  (** the shares of a law of a leaf, or those kept from before *)
}

val rationals : Rat.t t
(** Probabilities as numbers. Shares of laws are those of {!Kinematics.setting}. *)

type open_ = Rat.t * Rational_function.t
(** A value for one value of the parameter, and the function. *)

val open_numbers : Ranges.range -> open_ t
(** [open_numbers range] is probabilities as numbers with their functions. A divisor that is 0 for some value
    strictly within the range of the parameter is an error like a division by zero. *)

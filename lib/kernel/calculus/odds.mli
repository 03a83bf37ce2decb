(** How likely something is left to chance (rule Lot). *)

open Scc_exact

type t =
  | Chance of Rat.t  (** the probability at each split instant, from 0 to 1 *)
  | Open_chance of Open_number.t  (** a chance that depends on a parameter *)
  | Rate of { rate : Rat.t; alone : Rat.t }
  (** [rate]: how often per unit of time, 0 or more; [alone]: the probability within a split step, if nothing
      competes with it *)

val compare : t -> t -> int
(** A total order: chances before those that depend on a parameter, and these before rates, each by their numbers.
    The field [alone] follows from the rate and the split step, and is not compared. *)

val hash : t -> int
(** A hash that agrees with {!compare}. *)

val to_string : t -> string
(** The text of the odds as in the language: [chance 1/10] or [rate 2]. *)

val within : step:Rat.t -> Rat.t -> Rat.t
(** [within ~step r], for r >= 0 and step > 0, is the probability q that an event of rate r happens within a
    step. For r = 0 it is 0. For r > 0 let v = 1 - exp(-r step), which is irrational. Then q is the simplest
    fraction with |q - v| < 2^-40 min(v, 1 - v). So q and 1 - q are both right to a relative error of 2^-40, and
    0 < q < 1. The computation takes longer as r step grows; models keep that product to {!greatest} at most. *)

val greatest : int
(** The greatest product of rate and split step that a model may have: 1000. *)

val shares : step:Rat.t -> t list -> Rat.t list
(** [shares ~step odds] is the probability of each of [odds] within a step where all of them compete. A chance
    keeps its probability. Several rates have together the probability of one rate that is their sum, divided
    among them in proportion to the rates. The sum of all shares may exceed 1. *)

val forms : step:Rat.t -> t list -> Rational_function.t list
(** [forms ~step odds] is the functions of the parameter whose values {!shares} gives. *)

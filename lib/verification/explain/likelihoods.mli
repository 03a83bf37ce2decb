(** Probabilities in words. *)

open Scc_ctl

val number : Scc_exact.Rat.t -> string
(** The exact number if it is short. A longer one is followed by a decimal in parentheses, and a very long one
    is only its decimal, as ["about 0.333333"]. *)

val measured : Eval.measured -> string
(** The interval from the lower bound of the least value to the upper bound of the greatest, as
    ["1/3"], ["123456789/987654321 (about 0.125)"], or ["in [1/4, 1/2]"] with decimals that are rounded
    outwards. *)

val in_full : Eval.measured -> string option
(** [in_full m] is {!measured} with all digits, as ["1/3"] or ["in [1/4, 1/2]"]. It is [None] if {!measured} has
    them already. *)

val known : Scc_property.Property.side -> Eval.measured -> string
(** A measured probability as ["the least probability is 1/3"]. *)

val side : Scc_property.Property.side -> string
(** ["least"] or ["greatest"]. *)

val is_exact : Eval.measured -> bool
(** [is_exact m] is true if one value is known exactly, or if the value is known to be infinite. *)

val equal : Scc_ctl.Eval.measured -> Scc_ctl.Eval.measured -> bool
(** [equal a b] is true if the known bounds of both are equal. *)

val values : (Scc_property.Property.side * Eval.measured) list -> string
(** A list of measured values: ["1/3"] or ["in [1/4, 1/2]"] if the same is known of the least and the greatest,
    else ["least 1/4, greatest 1/2"]. *)

val of_run : Scc_exact.Rat.t -> string
(** The introduction to a shown run that attains a probability, with the probability of this run if it is less
    than 1. *)

val of_sides : is_chain:(unit -> bool) -> 'side list -> ('side -> 'a) -> ('side * 'a) list
(** [of_sides ~is_chain sides find] is what [find] finds for each side. Where nothing is left to choose, as
    [is_chain ()] says, what is found for the first side is so for the others. *)

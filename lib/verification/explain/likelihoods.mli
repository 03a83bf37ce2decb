(** Probabilities in words. *)

open Scc_ctl

val number : Scc_exact.Rat.t -> string

val answer : Scc_chance.Answer.t -> string
(** ["1/3"], ["123456789/987654321 (about 0.125)"], ["in [1/4, 1/2]"] with decimals that are rounded outwards. *)

val measured : Eval.measured -> string
(** The same of what is known below and above. *)

val known : Scc_property.Property.side -> Eval.measured -> string
(** ["the least probability is 1/3"]. *)

val is_exact : Eval.measured -> bool

val values : (Scc_property.Property.side * Eval.measured) list -> string
(** ["1/3"] where all schedulers have the same, ["least 1/4, greatest 1/2"]. *)

val of_run : Scc_exact.Rat.t -> string
(** Before what happens on one run: with which probability it comes to be. *)

(** What a property asks of one run: a formula about the path alone, a number, or that it cannot be told from a
    run. *)

open Scc_exact
open Scc_calculus
open Scc_property

type question =
  | Does  (** whether a run does as the formula says *)
  | Amounts of Property.mean * Range.t option
  (** what the run comes to, and where that always is, if this is known beforehand *)

type t = {
  check : Property.check;
  question : question;
  formula : Property.temporal;  (** over all runs of the one that there is *)
  horizon : Rat.t option;  (** model time after which it is decided; [None]: it may never be *)
}

val test : t -> (Property.side * Scc_chance.Answer.bound) option
(** What it is compared with; [None]: a number is asked for. *)

val of_check : Model.t -> Property.check -> (t, string) result
(** Of a check of the model: of [P ... \[f U g\]] and its like, and of [E ...], where what is inside is about
    states. Otherwise why it cannot be judged on single runs. *)

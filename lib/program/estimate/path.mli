(** The question that a property has about one run: a formula about the path alone, or a number. *)

open Scc_exact
open Scc_calculus
open Scc_property

(** The kind of answer of a run. *)
type question =
  | Does  (** true if the run satisfies the formula *)
  | Amounts of Property.mean * Range.t  (** the number of the run, and the range that it always is in *)

(** A property with its question. *)
type t = {
  check : Property.check;
  question : question;
  formula : Property.temporal;  (** over all runs of a chain, which has only one *)
  horizon : Rat.t option;  (** model time after which it is decided; [None]: it may never be *)
}

val atoms : t -> Atom.t list
(** The atoms of its formula and number, with repetitions. *)

val seen : t list -> int list option
(** The leaves whose processes the formulas and numbers of all these paths depend on, in order. [None]: they depend
    on the network as a whole, by more than sums over all processes ({!Atom.t.total}). *)

val test : t -> (Property.side * Scc_chance.Answer.bound) option
(** What it is compared with; [None]: a number is asked for. *)

val of_check : ?from:State.t -> Model.t -> Property.check -> (t, string) result
(** The question of a check of the form [P ... \[f U g\]] or [E ...] whose operands are state formulas. [from] is
    the state in which runs begin: more ranges are known with it. The error is the reason why single runs cannot
    answer any other check. *)

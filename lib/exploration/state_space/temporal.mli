(** Formulas of timed CTL on the state space of a model, as far as it was explored. *)

open Scc_ctl
open Scc_property

type asked
(** Formulas over one system. *)

val ask : Network_lts.context -> Property.temporal list -> asked

type t
(** The formulas on a graph. *)

val on : asked -> rests:(int array -> bool) -> State_graph.t -> t
(** States whose expansion is not done, for whatever reason, count as unexplored. [rests] says of a state without
    transitions whether time passes there for ever. *)

val truth : t -> int -> bool option
(** Of the formula of this index, in the initial state; [None]: undecided. *)

val done_with : t -> int -> unit
(** This formula and all before it are not asked about any more: what was found for them alone is forgotten. *)

val probability : t -> int -> Property.side -> Scc_ctl.Eval.measured
(** Of the operator of time that the formula of this index is: with which probability a run from the initial state
    does as it says. *)

val explain : t -> int -> Explanation.t
(** Of one that is decided. *)

val doubts : t -> int -> Scc_ctl.Doubts.t
(** Of one that is not. *)

val mean : t -> int -> Property.side -> Property.mean -> Scc_ctl.Expectation.answer
(** Of a check that asks for it, of which the formula of this index is that. *)

val probabilities : t -> int -> Scc_ctl.Eval.measured list
(** What is known of the probabilities that a formula compares in the initial state. *)

val possible_doubts : t -> int -> Scc_ctl.Doubts.t
(** What keeps the probability of one from being known. *)

val doubts_of_mean : t -> int -> Scc_ctl.Doubts.t
(** What keeps the mean of one from being known. *)

val formula : t -> int -> Scc_ctl.Formula.t
(** That of an index. *)

val predicate : t -> int -> Property.prop
(** That of a number in explanations and doubts. *)

(** {1 Runs} *)

val choice : t -> Scc_ctl.Run.step -> State_graph.step
(** The step by its index among all transitions of the state. *)

val flow_choice : t -> int -> int option
(** The first time transition of a state; [None] where time passes for ever. *)

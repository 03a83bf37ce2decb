(** Formulas of timed CTL on a timed graph whose nodes are states of a network, wherever these are stored. *)

open Scc_exact
open Scc_ctl
open Scc_property

type asked
(** A list of formulas, with their predicates prepared for one system. *)

val ask : Network_lts.context -> Property.temporal list -> asked
(** [ask c formulas] prepares [formulas] for the system [c]. Below, a formula is given by its index in this list,
    from 0. *)

val predicates : asked -> On_the_fly.predicate array
(** The predicates of the formulas, by their numbers. *)

val prop : asked -> int -> Property.prop
(** The state predicate with this number. *)

(** A graph of states. *)
type on = {
  graph : Timed_graph.t;
  predicates : Eval.predicates;  (** those of {!predicates} *)
  number : Property.num -> int -> Rat.t -> (Rat.t, string) result;
  (** the value of a number at an offset of the flow of a node, or why it has none *)
  counted : Property.prop -> int -> int -> int * int;
  (** how many things of which the predicate holds happen by an edge of a node, given by its index: at least and
      at most *)
}

type t
(** Formulas on a graph. *)

val on : ?surroundings:Scc_graph_search.Limits.surroundings -> ?seconds:float -> asked -> on -> t
(** [on ?surroundings ?seconds asked on] evaluates the formulas on a graph. Probabilities that take longer than
    the surroundings (default: {!Scc_graph_search.Limits.quiet}) allow are intervals. Exact values may take as
    much work as fits into so many seconds, and some in any case. *)

val eval : t -> Eval.t
(** The evaluator. *)

val formula : t -> int -> Timed_formula.t
(** The formula with this index. *)

val truth : t -> int -> bool option
(** The truth of the formula with this index in the initial state; [None] if it is undecided. *)

val done_with : t -> int -> unit
(** Declares that the formula with this index, and all before it, are not used any more. The memory for their
    values is released. *)

val is_cut_short : t -> bool
(** [is_cut_short t] is true if a probability or mean that was computed since {!done_with} was called, or ever, is
    less well known than it would be with more time. *)

val not_exact : t -> Scc_chance.Lifting.given_up option
(** [not_exact t] is the reason why exact values of a probability or mean were given up for intervals, since
    {!done_with} was called, or ever; [None] if none were. *)

val is_chain : t -> bool
(** [is_chain t] is true if no state of the graph leaves a choice ({!Timed_graph.is_chain}): then least and
    greatest probabilities and means are equal. *)

val probability : t -> int -> Property.side -> Eval.measured
(** [probability t i side] is the least or greatest probability of the runs from the initial state that satisfy the
    operator F, G or U at the top of formula [i]. *)

val curve :
  t -> int -> Property.side -> ((Timeline.moment * Eval.measured) list, string) result option
(** [curve t i side] is {!probability} for all ends of the bound of time of formula [i] ({!Eval.curve}). *)

val doubts : t -> int -> Doubts.t
(** The unexplored nodes and undefined predicates that keep a formula undecided in the initial state. *)

val mean :
  ?bound:Scc_chance.Answer.bound -> t -> int -> Property.side -> Property.mean -> Expectation.answer
(** [mean t i side mean] is the least or greatest mean over the runs from the initial state (rule Expectation).
    [i] is the index of the formula of the check with this mean. Another formula is a bug. An interval that decides
    [bound] is good enough, if it is given. *)

val probabilities : t -> int -> Eval.measured list
(** The known bounds of the probabilities that a formula compares in the initial state, in order. *)

val possible_doubts : t -> int -> Doubts.t
(** The unexplored nodes and undefined predicates that keep the probability of a formula from being known. *)

val doubts_of_mean : t -> int -> Doubts.t
(** The unexplored nodes and undefined predicates that keep the mean of a check from being known. *)

val what : t -> int -> Property.mean -> Expectation.what
(** [what t i mean] is the mean, as a sum or value over runs of the graph. *)

(** {1 What states have beside predicates} *)

val number_at :
  Network_lts.context -> int array -> Timeline.extent -> Property.num -> Rat.t -> (Rat.t, string) result
(** [number_at context tuple extent n offset] is the value of [n] at an offset of the trajectory from a state,
    which has this extent, or why it has none. *)

val counted_by : Network_lts.context -> int array -> int -> Property.prop -> int * int
(** [counted_by context tuple label p] is how many things of which [p] holds happen by a transition of the state
    with this label ({!Catalogue}): at least and at most. *)

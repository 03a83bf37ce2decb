(** Formulas of timed CTL on the state space of a model, as far as it was explored. *)

open Scc_ctl
open Scc_property

type asked = Formulas.asked
(** A list of formulas, with their predicates prepared for one system. *)

val ask : Network_lts.context -> Property.temporal list -> asked
(** [ask c formulas] prepares [formulas] for the system [c]. Below, a formula is given by its index in this list,
    from 0. *)

type t
(** Formulas on a graph. *)

val on :
  ?surroundings:Scc_graph_search.Limits.surroundings ->
  ?seconds:float ->
  asked -> rests:(int array -> bool) -> State_graph.t -> t
(** [on ?surroundings ?seconds asked ~rests graph] evaluates the formulas on [graph]. States that have not been
    expanded count as unexplored. [rests] is true for a state without transitions in which time passes for ever.
    Probabilities that take longer than the surroundings (default: {!Scc_graph_search.Limits.quiet}) allow are
    intervals. Exact values may take as much work as fits into so many seconds, and some in any case. *)

val formulas : t -> Formulas.t
(** The formulas on this graph: their truth, probabilities, means and doubts. *)

val explain : t -> int -> Explanation.t
(** The explanation of a formula that is decided in the initial state.
    @raise Scc_ctl.Explanation.Not_known as {!Scc_ctl.Explanation.explain} *)

val contrast : t -> Explanation.t -> (Explanation.t * int) option
(** [contrast t e] is a run of the graph that does otherwise than the run of the explanation [e], as an explanation
    of the opposite, with the number of steps of the graph that both share ({!Scc_ctl.Contrast.explain}). It is
    [None] if there is none, or [e] has no run. *)

(** {1 As functions of a parameter} *)

type sensitivity
(** A graph with its probabilities as functions of a parameter (rule Parametric). *)

val sensitivity : t -> Scc_calculus.Ranges.range -> sensitivity
(** [sensitivity t range] is the graph of [t], which has no joint draws, for the values within the range. May raise
    {!Edge_functions.Ambiguous} or {!Edge_functions.Refused}. *)

val probability_function :
  sensitivity -> int -> Property.side -> Scc_chance.Parametric.piece list Scc_ctl.Sensitivity.result
(** [probability_function s i side] is {!Formulas.probability} as a function of the parameter. *)

val mean_function :
  sensitivity -> int -> Property.side -> Property.mean ->
  Scc_chance.Parametric.piece list Scc_ctl.Sensitivity.result
(** [mean_function s i side mean] is {!Formulas.mean} as a function of the parameter. *)

val where : sensitivity -> int -> Scc_chance.Dependence.set Scc_ctl.Sensitivity.result
(** [where s i] is the values of the parameter for which the formula with this index holds. *)

(** {1 Predicates} *)

val predicate : t -> int -> Property.prop
(** The state predicate with this number in skeletons, explanations and doubts. *)

(** {1 Runs} *)

val choice : t -> Scc_ctl.Run.step -> State_graph.step
(** The step of a run in the graph, by its index among all transitions of its source. *)

val flow_choice : t -> int -> int option
(** The index of the first time transition of a state among all its transitions; [None] if it has none. *)

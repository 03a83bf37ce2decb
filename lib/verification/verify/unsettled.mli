(** A finished exploration, and the reasons why it leaves something open. *)

open Scc_exact
open Scc_calculus
open Scc_semantics
open Scc_graph_search
open Scc_state_space

type t = {
  bounds : Bounds.t;
  surroundings : Limits.surroundings;
  model : Model.t;
  context : Network_lts.context;
  graph : State_graph.t;
  horizon : Rat.t option;  (** the time beyond which no property looks *)
  lost : Lost.t;
  contrast : bool;  (** {!Setup.contrast} *)
}

val run : t -> (unit -> Scc_explain.Witness.t option) -> Scc_explain.Witness.t option
(** A run that is shown. [None] if it is lost ({!Lost.run}). *)

val explained : t -> Temporal.t -> int -> Scc_explain.Witness.t option
(** The run that explains a formula that is decided. [None] if it is lost, or there is none. *)

val reasons : t -> int Seq.t -> Transition.fault Explore.reason list
(** The reasons why these states were not expanded: all faults, and each other reason once, in the order of the
    states. *)

val first : t -> Transition.fault Explore.reason -> int option
(** The first state that was not expanded for a reason that is no fault. *)

val met : t -> Bounds.cause list
(** The causes for which states were not expanded, each once. *)

val stopped_by : Bounds.cause list -> Verdict.truncation list
(** The bounds among causes, as truncations. *)

val evaluated : t -> (unit -> 'a) -> ('a, Verdict.reason list) result
(** [evaluated t f] is the result of [f], which evaluates something on the graph, or the reason why there was too
    little time or memory for it. *)

val cut_short : t -> Temporal.t -> Verdict.reason list
(** [cut_short t temporal] is the reason why a probability or mean of the present formula is not better known, if
    it is that the time was over. *)

val causes : ?cut_short:bool -> t -> int Seq.t -> Verdict.reason list
(** [causes ?cut_short t states] is the reasons of a verdict why these states were not expanded: bounds, then
    faults, each once. If all had been decided before they were, it is a bug, unless the evaluation was cut short
    (default: it was not). *)

val unexplored : ?cut_short:bool -> t -> int Seq.t -> Verdict.reason list
(** [unexplored ?cut_short t states] is the {!causes} for these states, and a run to the nearest of them, unless it
    is lost. *)

val search_doubts : t -> Search.doubts -> Verdict.reason list
(** The reasons why a search is open: an undefined predicate, and the {!unexplored} states that matter. *)

val undefined : Search.doubts -> Verdict.reason list
(** The reason that the predicate of a search is undefined somewhere, if it is. *)

val doubts : t -> Temporal.t -> Scc_ctl.Doubts.t -> Verdict.reason list
(** [doubts t temporal d] is the reasons why a formula of [temporal] is open: undefined predicates, sorted, and the
    {!unexplored} states that matter. *)

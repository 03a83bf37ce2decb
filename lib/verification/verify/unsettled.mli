(** An exploration that is over, and why it leaves something open. *)

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
  horizon : Rat.t option;  (** the time beyond which nothing is asked *)
  lost : Lost.t;
}

val run : t -> (unit -> Scc_explain.Witness.t option) -> Scc_explain.Witness.t option
(** A run that is shown, unless it is lost ({!Lost.run}). *)

val cause : t -> Transition.fault Explore.reason -> Bounds.cause

val reasons : t -> int Seq.t -> Transition.fault Explore.reason list
(** Why these states were not expanded: all faults, and each other reason once, in the order of the states. *)

val first : t -> Transition.fault Explore.reason -> int option
(** The first state that was not expanded for a reason that is no fault. *)

val met : t -> Bounds.cause list
(** Why states were not expanded at all, each cause once. *)

val stopped_by : Bounds.cause list -> Verdict.truncation list
(** The bounds among them. *)

val evaluated : t -> (unit -> 'a) -> ('a, Verdict.reason list) result
(** What is found on the graph, or why there was too little time or memory for it. *)

val causes : t -> int Seq.t -> Verdict.reason list
(** Why these states were not expanded. *)

val unexplored : t -> int Seq.t -> Verdict.reason list
(** The same, with a run to the nearest of them, unless it is lost. *)

val search_doubts : t -> Search.doubts -> Verdict.reason list
val undefined : Search.doubts -> Verdict.reason list
val doubts : t -> Scc_ctl.Doubts.t -> Verdict.reason list

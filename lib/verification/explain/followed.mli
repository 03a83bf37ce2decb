(** Runs on a graph of states, followed through the rules. A state of the graph may stand for several, which differ
    by the names of interchangeable bodies or by their place; the real states of a run are found one after the
    other. *)

open Scc_calculus
open Scc_state_space

type t = {
  last : State.t;  (** the real state that has been reached *)
  steps : Witness.step list;  (** from the start, the last first *)
}

val start : Network_lts.context -> t
(** No steps, from the initial state. *)

val from : State.t -> t
(** No steps, from a state. *)

val step : Network_lts.context -> t -> int -> int array -> t
(** [step context run choice target] goes on to a state that the tuple [target] of the graph stands for. The
    transition number [choice] is tried first. It is a bug if no transition leads there. *)

val along : Network_lts.context -> State_graph.t -> t -> State_graph.step list -> t
(** [along context graph run steps] goes on by steps of the graph. *)

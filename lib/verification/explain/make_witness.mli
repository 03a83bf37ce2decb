(** Witnesses from what was found on a graph of states: each run is followed through the rules afresh, from the
    initial state, before anyone is shown it. *)

open Scc_ctl
open Scc_exact
open Scc_calculus
open Scc_semantics
open Scc_property
open Scc_state_space

val of_trace : Network_lts.context -> State_graph.t -> Property.prop option -> Search.trace -> Witness.t
(** With the facts of the predicate where the run leads. *)

val of_met : Network_lts.context -> Property.prop -> Compact_search.met -> Witness.t
(** With the facts of the predicate where the run leads. *)

val of_path : Network_lts.context -> State_graph.t -> int -> Witness.t
(** The shortest run to a state. *)

val of_explanation : Network_lts.context -> State_graph.t -> Temporal.t -> Explanation.t -> Witness.t option
(** The run that the explanation begins with, with the whole of it in words; [None] when there is no run in it. *)

(** {1 Runs that come back} *)

val moved : State.t -> State.t -> Vec.t option
(** [moved from state]: by how much the second is the first one moved as a whole, whatever time it is, if it is. *)

val puts_off : Semantics.t -> Witness.step list -> from:State.t -> Transition.label option
(** A weak split that is enabled somewhere on a cycle, which begins in a state, and never made on it. *)

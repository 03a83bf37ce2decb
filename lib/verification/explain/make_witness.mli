(** Witnesses of results on a graph of states. Each run is followed through the rules again, from the initial
    state, before it is shown. *)

open Scc_ctl
open Scc_exact
open Scc_calculus
open Scc_semantics
open Scc_property
open Scc_state_space

val of_trace : Network_lts.context -> State_graph.t -> Property.prop option -> Search.trace -> Witness.t
(** The run of a trace, with the facts of the predicate at its end. *)

val of_met : Network_lts.context -> Property.prop -> Compact_search.met -> Witness.t
(** The run to a state that a search with hash compaction has met, with the facts of the predicate at its
    end. *)

val of_cycle : Network_lts.context -> int list -> from:int -> Witness.t
(** The run of these choices, which comes back to the state after the first [from] of them. *)

val of_path : Network_lts.context -> State_graph.t -> int -> Witness.t
(** The shortest run to the state of a number. *)

val of_explanation : Network_lts.context -> State_graph.t -> Temporal.t -> Explanation.t -> Witness.t option
(** The run with which the explanation begins, and the whole explanation in words. [None] if the explanation
    has no run. *)

val with_contrast :
  Network_lts.context -> State_graph.t -> Temporal.t -> Explanation.t -> Witness.t -> Witness.t
(** [with_contrast c g t e w] is the run [w] of the explanation [e] with the run that does otherwise, if there is
    one ({!Witness.otherwise}). *)

(** {1 Runs that come back} *)

val moved : State.t -> State.t -> Vec.t option
(** [moved from state] is the vector by which [state] is [from] moved as a whole, at whatever time. [None] if
    it is not. *)

val puts_off : Semantics.t -> Witness.step list -> from:State.t -> Transition.label option
(** [puts_off m steps ~from] is a weak split that is enabled somewhere on a cycle of steps from the state
    [from], and never made on it. [None] if there is none. *)

(** Witnesses from what was found on a graph of states: each run is followed through the rules afresh, from the
    initial state, before anyone is shown it. *)

open Scc_ctl
open Scc_property
open Scc_space
module Engine : module type of Engine.Make (System) (State_graph)

val of_trace : System.context -> State_graph.t -> Property.prop option -> Engine.trace -> Witness.t
(** With the facts of the predicate where the run leads. *)

val of_met : System.context -> Property.prop -> Compaction.met -> Witness.t
(** With the facts of the predicate where the run leads. *)

val of_path : System.context -> State_graph.t -> int -> Witness.t
(** The shortest run to a state. *)

val of_explanation : System.context -> State_graph.t -> Temporal.t -> Explanation.t -> Witness.t option
(** The run that the explanation begins with, with the whole of it in words; [None] when there is no run in it. *)

val of_cycle : System.context -> State_graph.t -> Temporal.t -> Ctl_formula.t -> Ctl_run.t -> Witness.t
(** A run from the initial state that goes round within one instant, on which a formula depends. *)

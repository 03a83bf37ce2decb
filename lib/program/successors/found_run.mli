(** A run that another program found by successors, as a run of the network. Each step is computed again by the
    rules. *)

open Scc_base
open Scc_property
open Scc_explain

val find : Filter.t -> goal:int -> int list -> (Property.check * Witness.t, Diag.t) result
(** The run of these choices, which are indices of successors, to the goal, at its last state or at a moment
    after it. The result also has the property that searches for the goal. A missing choice, or a run that does
    not meet the goal, is SC0923. *)

val cycle : Filter.t -> from:int -> int list -> (Witness.t, Diag.t) result
(** The run of these choices, which comes back, within one instant, to the state after the first [from] of them. A
    missing choice, or a run that does not come back, is SC0923. *)

(** What is to be replayed: the run to a goal, or one that comes back. *)
type request = Goal of int * int list | Cycle of int * int list

val request : string -> (request, Diag.t) result
(** Reads [{"goal": 0, "choices": [...]}] or [{"cycle": 0, "choices": [...]}]; any other text is SC0923. *)

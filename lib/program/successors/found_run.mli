(** A run that another program found by successors, as a run of the network. Each step is computed again by the
    rules. *)

open Scc_base
open Scc_property
open Scc_explain

val find : Filter.t -> goal:int -> int list -> (Property.check * Witness.t, Diag.t) result
(** The run of these choices, which are indices of successors, to the goal, at its last state or at a moment
    after it. The result also has the property that searches for the goal. A missing choice, or a run that does
    not meet the goal, is SC0923. *)

val request : string -> (int * int list, Diag.t) result
(** Reads [{"goal": 0, "choices": [...]}]; any other text is SC0923. *)

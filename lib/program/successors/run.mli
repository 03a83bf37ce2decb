(** A run that somebody has found by the successors of states, as one of the network: each step is followed by the
    rules afresh. *)

open Scc_base
open Scc_property
open Scc_explain

val find : Filter.t -> goal:int -> int list -> (Property.check * Witness.t, Diag.t) result
(** That takes these choices, places among the successors that the filter told, and meets the goal where it leads,
    at the state or at a moment after it; with the property that searches for the goal. SC0923 where there is no
    such choice, or it does not meet the goal. *)

val request : string -> (int * int list, Diag.t) result
(** [{"goal": 0, "choices": [...]}]; SC0923 otherwise. *)

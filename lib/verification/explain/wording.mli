(** Explanations in words. *)

open Scc_ctl
open Scc_state_space

val facts :
  Network_lts.context -> State_graph.t -> Temporal.t -> last:Scc_calculus.State.t -> Explanation.t -> string list
(** The facts at the end of the run of an explanation ({!Scc_ctl.Explanation.chain}), a sentence for each atom.
    [last] is the state of the model from which the run goes on at its end. *)

val argument : Network_lts.context -> State_graph.t -> Temporal.t -> Explanation.t -> Witness.argument option
(** The explanation as a tree. [None] if it is only one run, with facts at its end. *)

(** {1 Parts of sentences}

    For runs that other modules find. *)

val listed : string list -> string list
(** The first twelve of some events in one line, with the number of the others. The empty list for no event. *)

val going_round : int -> silent:bool -> Scc_exact.Rat.t -> string
(** [going_round k ~silent t] is the sentence for a run that repeats its steps from index [k] on, which begin
    at the time [t] of the run. With [silent], none of these steps is an event. *)

val beyond : string -> bool -> string -> string option
(** [beyond claim holds fact] is the part of [fact] that goes beyond the sentence that the claim holds, or
    fails. [None] if there is none. *)

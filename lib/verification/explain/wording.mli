(** Explanations in words. *)

open Scc_ctl
open Scc_state_space

val facts : Network_lts.context -> State_graph.t -> Temporal.t -> Explanation.t -> string list
(** What holds where the run of an explanation ({!Explanation.chain}) leads, a sentence for each atom. *)

val argument : Network_lts.context -> State_graph.t -> Temporal.t -> Explanation.t -> Witness.argument option
(** The whole tree; [None] when it is but one run, with what holds at its end. *)

(** {1 Parts of sentences}

    For runs that come from elsewhere. *)

val listed : string list -> string list
(** The first of some events in one line. *)

val going_round : int -> silent:bool -> Scc_exact.Rat.t -> string
(** Of a run that repeats its steps from this index on, so long after it began; [silent]: none of them is an
    event. *)

val beyond : string -> bool -> string -> string option
(** What a fact says that the claim does not, which holds or fails. *)

(** Explanations in words. *)

open Scc_ctl
open Scc_space

val facts : Network_lts.context -> State_graph.t -> Temporal.t -> Explanation.t -> string list
(** What holds where the run of an explanation ({!Explanation.chain}) leads, a sentence for each atom. *)

val argument : Network_lts.context -> State_graph.t -> Temporal.t -> Explanation.t -> Witness.argument option
(** The whole tree; [None] when it is but one run, with what holds at its end. *)

(** The line on a terminal that shows the progress of an exploration. *)

open Scc_graph_search

val show : ?about:string -> Console.t -> Scc_verdicts.Budget.t -> Limits.progress -> unit
(** Shows the line at most ten times a second, and at once when the exploration is over and values begin. It is
    shown only if standard error is a terminal, or if lines of progress are wanted. Partial application starts the
    clock. The line begins with [about], if there are several explorations. *)

(** The line on a terminal that shows the progress of an exploration. *)

open Scc_graph_search

val line : bounds:Scc_verdicts.Budget.t -> elapsed:float -> heap:int -> Limits.progress -> string
(** States and states per second, states still to expand, depth, model time, and memory ([heap] in bytes). With
    a bound of states or seconds it also has the longest time until the bound is met at the present rate.
    [elapsed] is in seconds. *)

val show : ?about:string -> Console.t -> Scc_verdicts.Budget.t -> Limits.progress -> unit
(** Shows the line, at most ten times a second, and only if standard error is a terminal. Partial application
    starts the clock. The line begins with [about], if there are several explorations. *)

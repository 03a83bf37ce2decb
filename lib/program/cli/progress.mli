(** The line on a terminal that says how far an exploration is. *)

open Scc_graph_search

val line : bounds:Scc_session.Budget.t -> elapsed:float -> heap:int -> Limits.progress -> string
(** States and how many of them a second, those still to expand, depth, model time, memory ([heap] in bytes);
    and for a bound of states or seconds how long it takes to meet it at most, at the rate so far. [elapsed] is
    in seconds. *)

val show : ?about:string -> Console.t -> Scc_session.Budget.t -> Limits.progress -> unit
(** Partial application starts the clock; the line is written at most ten times a second, and only if standard
    error is a terminal. It begins with what it is [about], where there are several explorations. *)

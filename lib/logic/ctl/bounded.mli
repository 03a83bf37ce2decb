(** The operators with a bound of time [0, b], by thresholds: when g comes at the earliest on some run, or at the
    latest on all of them. No clock enters the graph. [generous] is as in {!Until}. *)

open Scc_exact

type times = int -> Timeline.moment option
(** From each node on. *)

val least :
  Timed_graph.index -> generous:bool -> bound:Rat.t -> f:Positions.t -> g:Positions.t -> times
(** The least time of a run to g through f: shortest paths backwards. [None]: no run, or not within the bound. *)

val greatest : Timed_graph.index -> generous:bool -> f:Positions.t -> g:Positions.t -> times
(** The greatest time to g through f, of all runs; [None]: on some run it does not come at all. *)

val in_time : Rat.t -> Timeline.moment option -> bool
(** Not after the bound. *)

val shift : Rat.t -> Timeline.moment -> Timeline.moment
(** So much later. *)

val earliest : times -> int array -> Timeline.moment option
val latest : times -> int array -> Timeline.moment option

val some :
  Timed_graph.index -> generous:bool -> bound:Rat.t -> f:Positions.t -> g:Positions.t -> Positions.t
(** E(f U[0,b] g). *)

val every :
  Timed_graph.index -> generous:bool -> bound:Rat.t -> f:Positions.t -> g:Positions.t -> Positions.t
(** A(f U[0,b] g). *)

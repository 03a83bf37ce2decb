(** The operators with a bound of time [0, b], by thresholds: the earliest time of g on some run, or the latest on
    all runs. The graph gets no clock. [generous] is as in {!Until}. *)

open Scc_exact

type times = int -> Timeline.moment option
(** For each node a time, counted from that node on. *)

val least :
  Timed_graph.index -> generous:bool -> bound:Rat.t -> f:Positions.t -> g:Positions.t -> times
(** [least index ~generous ~bound ~f ~g] is the least time of a run to g through f, by shortest paths backwards.
    [None] if there is no such run, or none within the bound. *)

val greatest : Timed_graph.index -> generous:bool -> f:Positions.t -> g:Positions.t -> times
(** [greatest index ~generous ~f ~g] is the greatest time of all runs to g through f; [None] if some run does not
    come to g. *)

val shift : Rat.t -> Timeline.moment -> Timeline.moment
(** [shift d m] is [m], later by [d]. *)

val earliest : times -> int array -> Timeline.moment option
(** [earliest times nodes] is the earliest time of the nodes; [None] if none has one. *)

val latest : times -> int array -> Timeline.moment option
(** [latest times nodes] is the latest time of the nodes; [None] if some node has none. *)

val some :
  Timed_graph.index -> generous:bool -> bound:Rat.t -> f:Positions.t -> g:Positions.t -> Positions.t
(** [some index ~generous ~bound ~f ~g] is the positions of E(f U[0,b] g). *)

val every :
  Timed_graph.index -> generous:bool -> bound:Rat.t -> f:Positions.t -> g:Positions.t -> Positions.t
(** [every index ~generous ~bound ~f ~g] is the positions of A(f U[0,b] g). *)

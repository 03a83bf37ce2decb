(** Nodes that can be reached, within a time or without a bound. *)

open Scc_exact

val visit :
  Timed_graph.t ->
  ?within:Rat.t ->
  Positions.position list ->
  through:(int -> bool) ->
  passes:(Positions.position -> bool) ->
  (int -> unit) ->
  unit
(** [visit g ~within positions ~through ~passes f] calls [f] once for each node that can be reached from one of the
    positions, nodes among these included. The search goes on from nodes that pass [through], and to the ends of
    flows from positions that pass [passes]. With [within] only nodes that are reached in this time count. For
    positions inside flows, the greatest offset of them is then added to the time for all. *)

(** What can be reached. *)

open Scc_exact

val visit :
  Timed_graph.t ->
  ?within:Rat.t ->
  Positions.position list ->
  through:(int -> bool) ->
  passes:(Positions.position -> bool) ->
  (int -> unit) ->
  unit
(** Calls the function once for each node that can be reached from one of the positions (within the time), these
    included, going on from nodes that it may go [through], and to the ends of flows that it [passes]. Of
    positions inside flows the greatest offset is taken for all, where the time counts. *)

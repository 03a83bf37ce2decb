(** Finite timed graphs, on which formulas are evaluated: numbered nodes, with edges and flows of time. They are
    made for millions of nodes. *)

open Scc_exact

(** The time transition of a node. It has one trajectory, which all targets share. *)
type flow =
  | No_flow
  | Lasts of Rat.t * int array  (** a positive time, and the nodes at its end: usually one, never none *)
  | Forever  (** time passes for ever *)

type t = {
  size : int;  (** nodes are 0 .. size - 1; runs begin in node 0 *)
  known : int -> bool;  (** [false] if the successors of the node were not explored *)
  edges : int -> int array;  (** the targets of its discrete transitions, which take no time *)
  drawn : int -> Rat.t option array option;
  (** For a node at which chance decides: the probability of each edge that is drawn, positive and with the sum 1,
      and [None] for each edge that is a choice of its own. Such a node has no flow. *)
  flow : int -> flow;  (** the time transition of the node *)
}
(** A node may have edges and a flow. A known node with neither is a dead end: the run is over, and no time passes
    any more. [edges], [drawn] and [flow] may be called only for known nodes. *)

val edges : t -> int -> int array
(** [edges g s] is the targets of the edges of node [s]; empty if it is not known. *)

val flow : t -> int -> flow
(** [flow g s] is the flow of node [s]; [No_flow] if it is not known. *)

val targets : flow -> int array
(** [targets flow] is the nodes at the end of the flow; empty for [No_flow] and [Forever]. *)

val is_dead_end : t -> int -> bool
(** [is_dead_end g s] is true if node [s] is known and has neither edges nor a flow. *)

val extent : flow -> Timeline.extent
(** [extent flow] is the length of the trajectory: [Instant] for [No_flow]. *)

(** How a run leaves a node. *)
type move =
  | Edge of int  (** by the edge of this index *)
  | Flow of int  (** at the end of its flow, to the target of this index *)

val edge_choices : t -> int -> (int * int * Rat.t) list list
(** [edge_choices g s] is the choices between edges at the known node [s]. Each choice is a list of edges: their
    indices, targets and probabilities. All edges that are drawn are the first choice, and each other edge is one
    of its own. *)

val is_chain : t -> bool
(** [is_chain g] is true if no known node leaves a choice: chance decides between all its edges, or it has one way
    to go on at most. All schedulers of [g] are one then, and least and greatest values are equal. *)

val target : t -> int -> move -> int
(** [target g s move] is the node that the move from node [s] leads to. *)

val duration : t -> int -> move -> Rat.t
(** [duration g s move] is the time of a move from node [s]: 0 for an edge, and the time of its flow otherwise. *)

(** {1 Backwards} *)

type index
(** A graph with its reversed edges, made once for all formulas: 4 bytes for each node, edge and target of a flow.
*)

val index : t -> index
(** [index g] is [g] with its reversed edges. [g] has less than 2{^30} nodes (a bug otherwise). *)

val graph : index -> t
(** [graph index] is the graph. *)

val complete : index -> bool
(** [complete index] is true if every node is known. *)

val iter_sources : index -> int -> (int -> bool -> unit) -> unit
(** [iter_sources index t f] calls [f s timed] for each way from [s] to [t], once for each edge (not [timed]) or
    target of the flow of [s] ([timed]). *)

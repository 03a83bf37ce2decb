(** A finite timed graph as the evaluation of formulas sees it: nodes and what follows them, nothing of what they
    are. Made for millions of nodes: nothing here is kept as a list. *)

open Scc_exact

(** The time transition of a node. It has one trajectory, which all targets share. *)
type flow =
  | No_flow
  | Lasts of Rat.t * int array  (** a positive time, and where it may lead: normally one node, never none *)
  | Forever  (** time passes for ever *)

type t = {
  size : int;  (** nodes are 0 .. size - 1; runs begin in node 0 *)
  known : int -> bool;  (** [false]: what follows the node was not explored *)
  edges : int -> int array;  (** the targets of its discrete transitions, which take no time *)
  drawn : int -> Rat.t array option;
  (** Of a node that it is left by lot: the probability of each edge, positive and with the sum 1; it has no flow.
  *)
  flow : int -> flow;
}
(** A node may have edges and a flow. One that is known and has neither is a dead end: the run is over, and no
    time passes any more. [edges], [drawn] and [flow] are only asked of nodes that are
    known. *)

val edges : t -> int -> int array
(** Empty where it is not known. *)

val flow : t -> int -> flow
(** [No_flow] where it is not known. *)

val targets : flow -> int array

val is_dead_end : t -> int -> bool
(** Known, without edges and without flow. *)

val extent : flow -> Timeline.extent

(** How a run leaves a node. *)
type move =
  | Edge of int  (** by the edge of this index *)
  | Flow of int  (** at the end of its flow, to the target of this index *)

val target : t -> int -> move -> int

val duration : t -> int -> move -> Rat.t
(** 0 for an edge, the time of the flow otherwise. *)

(** {1 Backwards} *)

type index
(** The edges the other way round, made once for all formulas: 8 bytes for each edge and node at most. *)

val index : t -> index
val graph : index -> t

val complete : index -> bool
(** Every node is known. *)

val iter_sources : index -> int -> (int -> bool -> unit) -> unit
(** [iter_sources index t f] calls [f s timed] for each way from [s] to [t], once for each edge (not [timed]) or
    target of the flow of [s] ([timed]). *)

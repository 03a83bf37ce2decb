(** Sets of positions of a timed graph: its nodes, and the offsets strictly inside their flows. Two bytes for each
    node; pieces are kept only for flows on which membership changes. *)

open Scc_exact

(** The offset is 0 at the node itself, and else positive and inside its flow. *)
type position = { node : int; offset : Algebraic.t }

val start : int -> position
(** A node itself. *)

val is_inside : position -> bool
(** Strictly inside the flow. *)

type t

val make : Timed_graph.t -> at:(int -> bool) -> along:(int -> Pieces.t) -> t
(** [along] is asked of nodes that have a flow. *)

val constant : Timed_graph.t -> bool -> t
val at : t -> int -> bool

val along : t -> int -> Pieces.t
(** Of a node that has a flow. *)

val mem : t -> position -> bool
val not_ : t -> t
val map2 : (bool -> bool -> bool) -> t -> t -> t

val equal_on : Timed_graph.t -> t -> t -> int -> bool
(** Whether two sets agree in a node and along its flow. *)

val equal : t -> t -> bool

val of_truth :
  Timed_graph.t -> at:(int -> Truth.t) -> along:(int -> Timeline.extent -> Truth.t Timeline.t) option -> t * t
(** Where it is true, and where it is true or undecided: one set when it is decided everywhere. Without [along] it
    is the same along the flow of a node as in the node. *)

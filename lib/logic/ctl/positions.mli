(** Sets of positions of a timed graph: its nodes, and the offsets strictly inside their flows. Two bytes for each
    node; pieces are kept only for flows on which membership changes. *)

open Scc_exact

(** A node (offset 0), or a positive offset inside its flow. *)
type position = { node : int; offset : Algebraic.t }

val start : int -> position
(** [start s] is node [s] itself. *)

val is_inside : position -> bool
(** [is_inside p] is true if [p] is strictly inside a flow. *)

type t

val make : Timed_graph.t -> at:(int -> bool) -> along:(int -> Pieces.t) -> t
(** [make g ~at ~along] is the set with the node s if [at s], and the offsets [along s] of its flow. [along] is
    called for nodes that have a flow. *)

val constant : Timed_graph.t -> bool -> t
(** [constant g v] is all positions for [true], and none for [false]. *)

val at : t -> int -> bool
(** [at set s] is true if node [s] is in the set. *)

val along : t -> int -> Pieces.t
(** [along set s] is the offsets in the set of the flow of node [s], which has one. *)

val mem : t -> position -> bool
(** [mem set p] is true if position [p] is in the set. *)

val not_ : t -> t
(** [not_ set] is the complement. *)

val map2 : (bool -> bool -> bool) -> t -> t -> t
(** [map2 f a b] has the positions at which [f] is true for the membership in [a] and in [b]. *)

val equal : t -> t -> bool
(** [equal a b] is true if two sets of one graph are stored alike: then they are equal. It may be false for equal
    sets that differ in what is stored for nodes without a flow. *)

val of_truth :
  Timed_graph.t -> at:(int -> Truth.t) -> along:(int -> Timeline.extent -> Truth.t Timeline.t) option -> t * t
(** [of_truth g ~at ~along] is the positions at which a predicate is true, and those at which it is true or
    undecided. They are physically one set if it is decided everywhere. Without [along] it is constant along the
    flow of each node. *)

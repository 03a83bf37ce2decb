(** Sets of the states of a graph of zones, at instants and between them, with their predecessors. {!Branching}
    computes formulas with them. *)

open Scc_polyhedra
open Scc_property
open Scc_state_sets

exception Not_known of string
(** The reason, for readers, why something is not known. *)

val not_known : string -> 'a
(** [not_known reason] raises {!Not_known}. *)

(** The effect of time on a region of a node until the next event: the states (y, d) strictly between. The
    variables of the node are y, and d > 0 is the time that has passed. *)
type stretch = {
  region : Polyhedron.t;  (** of the node *)
  zone : Zone.t;  (** the trajectory *)
  for_ever : bool;  (** nothing comes next *)
}

type node = {
  it : Zone_graph.node;
  stretches : stretch list;
  happens : Zone_graph.edge list;  (** at once *)
  passes : Zone_graph.edge list;
  splits : (Zone_graph.edge * Zone_graph.edge list option) list;
  (** edges to a halted node, each with the events there: from the node, or from states of stretches; [None] if
      the halted node is not expanded *)
}

type sets = {
  at : Union.t array;  (** of each node *)
  along : Union.t list array;  (** of each of its stretches *)
}

type model = {
  nodes : node array;
  atoms : Atoms.context;
  before : int list array;  (** for each node, those from which an event leads to it *)
  whole : bool;  (** all nodes are expanded *)
}

val of_graph : Instant.context -> Atoms.context -> Zone_graph.t -> model
(** The model of a graph: its nodes with their stretches and their edges by kinds. *)

(** {1 Sets} *)

val is_explored : node -> bool
(** [is_explored n] is true if [n] is expanded. Nothing is known of what follows the states of other nodes. A set
    of states is then computed twice: with [may], it has all states that may belong to it, and otherwise those that
    surely do. *)

val unknown : node -> may:bool -> Union.t
(** The states of a node that is not expanded, of a set of which nothing is known there: all of them with [may],
    and otherwise none. *)

val of_prop : model -> may:bool -> Property.prop -> sets
(** The states where a predicate is true. Raises {!Not_known} if it is undecided somewhere. *)

val everything : model -> may:bool -> sets
(** All states of nodes that are not halted, and of their stretches. *)

val complement : model -> sets -> sets
(** The states of nodes and stretches that are not in the sets. *)

val map2 : (Union.t -> Union.t -> Union.t) -> sets -> sets -> sets
(** [map2 f a b] applies [f] to each two sets of one node or stretch. *)

val tidy : Union.t -> Union.t
(** The set, by fewer pieces where possible ({!Scc_polyhedra.Union.merged}). *)

val some : Polyhedron.t -> Union.t
(** The set with one polyhedron as its only piece. *)

val all_along : stretch -> Union.t
(** All states of a stretch. *)

val union : Union.t -> Union.t -> Union.t
(** The union, by fewer pieces where possible. *)

val inter : Union.t -> Union.t -> Union.t
(** The intersection, by fewer pieces where possible. *)

val project : Union.t -> dimension:int -> Union.t
(** [project u ~dimension] is the projection to the first [dimension] variables. *)

val restrict : Union.t -> Constraint.t list -> Union.t
(** [restrict u constraints] has the states of [u] that satisfy the constraints. *)

(** {1 Backwards}

    The states from which a set of states of nodes is reached; the array has a set for each node. *)

val at_once : node -> Union.t array -> Union.t
(** The states of the node from which an event leads into the set without delay. *)

val halts : node -> stretch -> Union.t array -> Union.t
(** The states of a stretch from which a weak split leads into the set. *)

val ends : node -> stretch -> Union.t array -> Union.t
(** The states of the node for which the end of a stretch leads into the set, over the variables of the
    node. *)

val late : node -> stretch -> Union.t
(** The states of the node for which the end of a stretch is beyond the horizon, over the variables of the
    node. *)

(** {1 Along a stretch} *)

val before_ : dimension:int -> int -> int -> Constraint.t
(** [before_ ~dimension i j] is the constraint that variable [i] is less than variable [j]. *)

val clear_until : stretch -> Union.t -> Union.t
(** [clear_until s bad] are the (y, d, d'), d <= d', such that no state strictly between is in [bad]. *)

val clear_to_end : stretch -> Union.t -> Union.t
(** [clear_to_end s bad] are the (y, d) such that no later state is in [bad]. *)

val reach : stretch -> bad:Union.t -> Union.t -> Union.t
(** [reach s ~bad target] are the (y, d) from which a state of [target] is reached, itself or later. No state
    before it is in [bad], except perhaps the first one. *)

val not_after : stretch -> bad:Union.t -> Union.t -> Union.t
(** [not_after s ~bad states] are those (y, d) of [states] that no earlier state in [bad] precedes. *)

val reach_from_start : stretch -> bad:Union.t -> Union.t -> Union.t
(** [reach_from_start s ~bad target] are the y from which a state of [target] is reached without an earlier
    state in [bad]. *)

val clear_from_start : stretch -> bad:Union.t -> Union.t
(** [clear_from_start s ~bad] are the y for which no state of the stretch is in [bad]. *)

val extend_over : stretch -> Union.t -> Union.t
(** [extend_over s u] are the (y, d) of the stretch with y in [u]. *)

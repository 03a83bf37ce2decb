(** Sets of the states of a graph of zones, at instants and between them, and how they follow each other: what
    {!Branching} computes formulas with. *)

open Scc_polyhedra
open Scc_property

exception Not_known of string
(** Why something is not known, for a person. *)

val not_known : string -> 'a

(** What time makes of a region of a node until what comes next: the states (y, d) that are strictly between, where
    y are the variables of the node, and d > 0 says how much time has passed. *)
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
  splits : (Zone_graph.edge * Zone_graph.edge list) list;
  (** to a halted node, with what may happen there: from the node, or from states of stretches *)
}

type sets = {
  at : Union.t array;  (** of each node *)
  along : Union.t list array;  (** of each of its stretches *)
}

type model = { nodes : node array; atoms : Atoms.context; before : int list array  (** who comes before a node *) }

val of_graph : Instant.context -> Atoms.context -> Zone_graph.t -> model

(** {1 Sets} *)

val of_prop : model -> Property.prop -> sets
(** Where a predicate is true; {!Not_known} where it is undecided somewhere. *)

val everything : model -> sets
val complement : model -> sets -> sets
val map2 : (Union.t -> Union.t -> Union.t) -> sets -> sets -> sets
(** Set by set. *)

val tidy : Union.t -> Union.t
(** The same by fewer pieces. *)

val some : Polyhedron.t -> Union.t
val all_along : stretch -> Union.t
val union : Union.t -> Union.t -> Union.t
val inter : Union.t -> Union.t -> Union.t
val project : Union.t -> dimension:int -> Union.t
(** To the first variables. *)

val restrict : Union.t -> Constraint.t list -> Union.t

(** {1 Backwards}

    From where a set of states of nodes is reached. *)

val at_once : node -> Union.t array -> Union.t
(** By an event, from the node itself. *)

val halts : node -> stretch -> Union.t array -> Union.t
(** By a weak split, from states of a stretch. *)

val ends : node -> stretch -> Union.t array -> Union.t
(** At the end of a stretch: over the variables of the node. *)

val late : node -> stretch -> Union.t
(** What is beyond the horizon at the end of a stretch: likewise. *)

(** {1 Along a stretch} *)

val before_ : dimension:int -> int -> int -> Constraint.t
(** That one variable is less than another one. *)

val clear_until : stretch -> Union.t -> Union.t
(** The (y, d, d'), d <= d', such that no state strictly between is in the set. *)

val clear_to_end : stretch -> Union.t -> Union.t
(** The (y, d) such that no later state is in the set. *)

val reach : stretch -> bad:Union.t -> Union.t -> Union.t
(** The (y, d) from which a state of a set is reached, itself or later, with none in [bad] before it but perhaps
    the first one. *)

val not_after : stretch -> bad:Union.t -> Union.t -> Union.t
(** Those (y, d) of a set that no state in [bad] is before. *)

val reach_from_start : stretch -> bad:Union.t -> Union.t -> Union.t
(** The y from which a state of a set is reached without one of [bad] before it. *)

val clear_from_start : stretch -> bad:Union.t -> Union.t
(** The y from which the whole stretch has no state in [bad]. *)

val extend_over : stretch -> Union.t -> Union.t
(** The (y, d) with y in a set. *)

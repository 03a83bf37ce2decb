(** The zones that a network reaches from all its starts, with the edges between them. They are found
    breadth-first; a zone that is contained in another one is not a node of its own. *)

open Scc_exact
open Scc_polyhedra
open Scc_property
open Scc_state_sets

(** A zone that is not expanded yet is merged with new states if their union is convex, so that fewer zones are
    expanded. *)

(** An edge is taken from those states of the source for which the guard holds. *)
type edge = {
  guard : Polyhedron.t;
  (** over the variables of the source, and of a [Passes_some] over one more, the last one: the time that
      passes *)
  step : Zone_steps.step;
  target : int;
  map : Linear.t array;  (** the variables of the target, as forms over those of the guard *)
  renamed : int array option;
  (** the names in the target of the leaves of the source, if they differ (rule Symmetry) *)
}

type node = {
  number : int;
  mutable zone : Zone.t;  (** canonical *)
  depth : int;  (** the least number of edges from a root *)
  mutable parents : (int * edge) list;
  (** The edges by which it was found, from nodes that were expanded before. Together they lead to all of its
      states. A root has none. *)
  mutable edges : edge list;
  mutable cells : Passing.due First.cell list;
  (** regions on which time passes undisturbed until the first events, with these events *)
  mutable late : Polyhedron.t list;
  (** the states whose next event comes after the horizon and is not followed, over the variables of the node *)
  beyond : int option;
  (** of states after the horizon: how many events have led to them after it; [None] up to the horizon *)
  mutable expanded : bool;
}

type t

val size : t -> int
(** The number of nodes, which are numbered from 0. *)

val node : t -> int -> node
(** The node of a number. *)

val roots : t -> node list
(** The nodes of the starts. *)

(** What becomes of states after the horizon. *)
type later =
  | Followed of int  (** so many events are followed, and the time that passes before each; what comes then is left
                         out, and {!node.late} has the states that lead there *)
  | Unexplored  (** they are nodes that are never expanded *)

(** The bounds of the exploration; [None]: no bound. *)
type limits = {
  depth : int option;
  nodes : int option;
  horizon : Rat.t option;  (** of time, if it is a coordinate of zones *)
  later : later;
}

type end_ =
  | Closed  (** all is known *)
  | Decided  (** the visitor's [enough] was true *)
  | Bounded of { depth : bool; nodes : bool }  (** some nodes were not expanded, for these bounds *)
  | Stopped  (** the visitor's [stop] was true, or an attempt was given up *)
  | Not_affine of string  (** the successors of some node are not affine, or not known, for this reason *)

type visitor = {
  found : node -> unit;
  expanded : node -> unit;
  late : Zone.t -> unit;  (** called with states that the horizon leaves out, at least in part *)
  enough : t -> bool;  (** called before each node, with the graph *)
  stop : unit -> bool;  (** called before each node; true stops the exploration *)
}

val explore :
  ?displaced:bool ->
  ?visible:(int -> bool) ->
  ?interchangeable:int list list ->
  ?attempt:((unit -> unit) -> bool) ->
  Instant.context ->
  events:Property.event array ->
  limits:limits ->
  visitor:visitor ->
  Zone.t list ->
  t * end_
(** Explores from zones, which need not be canonical: the roots are their canonical forms. With [displaced]
    each zone that is reached is {!Zone_form.centred} first: the place of the whole does not matter.
    With [visible],
    independent events of one instant are followed in one order where no visible leaf takes part (rule Order);
    for searches only. Leaves of a class of [interchangeable] may be exchanged (rule Symmetry); the members of
    each class are increasing. Roots are never changed so. Each node is expanded by [attempt], which may give
    it up at any point and return false. Then the exploration is stopped, and the node is not expanded. *)

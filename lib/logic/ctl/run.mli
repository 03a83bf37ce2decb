(** Runs of a timed graph that show why a formula holds or does not. *)

open Scc_exact

type step = { source : int; move : Timed_graph.move }

(** Where a run is taken to after its steps. *)
type finish =
  | At_state  (** to its last node *)
  | During of { moment : Timeline.moment; sample : Algebraic.t }
  (** to a moment inside the flow of the last node; the sample is an offset at which what begins at the moment
      holds *)
  | Rests  (** the flow of the last node lasts for ever, and the run stays in it *)
  | Stops  (** the last node is a dead end: the run is over *)
  | Repeats of int  (** back to the node before the step of this index, for ever *)
  | Passes  (** past the bound of time, inside the flow of the last node *)

type t = {
  start : Positions.position;
  (** when it is inside a flow, the first step, if any, is the end of that flow, and otherwise the finish is
      in it *)
  steps : step list;
  last : int;
  finish : finish;
}

val goal : t -> Positions.position option
(** The position to which the run is taken, when it ends in one. *)

val during :
  Timed_graph.t ->
  f:Positions.t ->
  g:Positions.t ->
  ?limit:Algebraic.t ->
  int ->
  Timeline.moment ->
  finish
(** To a moment inside the flow of a node; where an open interval begins there, to an offset in it at which neither
    of the sets has changed, and before the limit. *)

val append : t -> t -> t
(** The second run begins where the first one ends ({!goal}). *)

(** {1 Search} *)

(** A position met by a search: a node, or the start of the run inside a flow. *)
type place = {
  position : Positions.position;
  left : Algebraic.t;
  (** the offset, inside the flow of the node, at which the bound is met: what is left of it at a node, and for
      a start inside a flow that and the offset together. Without a bound, of 0. *)
}

type 'r judgement =
  | Found of 'r
  | Follow of { edge : int -> bool; flow : int -> bool }
  (** the targets to go on to; from a start inside a flow only by the flow *)

type 'r found = { steps : step list; last : int; result : 'r }

type region
(** What a search has seen. *)

val search :
  Timed_graph.t ->
  ?by_time:bool ->
  ?bound:Rat.t ->
  Positions.position ->
  (place -> 'r judgement) ->
  ('r found, region) result
(** Breadth-first, so that the steps are as few as can be. Each node is looked at once, or, with [by_time], once
    for each time at which it is met. *)

val lasso : region -> prefer:(Timed_graph.move -> bool) -> t option
(** A run along the ways that the search followed that ends in a cycle: through a move (the first such) that is
    preferred, if there is one, or else the first cycle. *)

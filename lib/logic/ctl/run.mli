(** Runs of a timed graph that show why a formula holds or does not. *)

open Scc_exact

type step = { source : int; move : Timed_graph.move }

(** The end of a run after its steps. *)
type finish =
  | At_state  (** to its last node *)
  | During of { moment : Timeline.moment; sample : Algebraic.t }
  (** To a moment inside the flow of the last node. [sample] is the offset of the moment, or one shortly after it
      if an open interval begins there. *)
  | Rests  (** the flow of the last node lasts for ever, and the run stays in it *)
  | Stops  (** the last node is a dead end: the run is over *)
  | Repeats of int  (** back to the node before the step of this index, for ever *)
  | Passes of Algebraic.t
  (** Past the bound of time, inside the flow of the last node: the offset in it at which the bound is met. *)

type t = {
  start : Positions.position;
  (** If it is inside a flow, the first step, if any, is the end of that flow. Without a step the finish is in that
      flow. *)
  steps : step list;
  last : int;  (** the node after all steps *)
  finish : finish;
}

val goal : t -> Positions.position option
(** [goal r] is the position at which the run ends; [None] if it is over, endless or goes past the bound. *)

val during :
  Timed_graph.t ->
  f:Positions.t ->
  g:Positions.t ->
  ?limit:Algebraic.t ->
  int ->
  Timeline.moment ->
  finish
(** [during g ~f ~g ~limit s moment] is the finish at a moment inside the flow of node [s]. If an open interval
    begins there, its sample is an offset in it before [limit], such that neither set changes in between. *)

val append : t -> t -> t
(** [append a b] is run [a], then run [b], which begins at the {!goal} of [a]. *)

(** {1 Search} *)

(** A position met by a search: a node, or the start of the run inside a flow. *)
type place = {
  position : Positions.position;
  left : Algebraic.t;
  (** The offset in the flow of the node at which the bound is met. At a node it is the rest of the bound. For a
      start inside a flow it is the rest plus the offset of the start. Without a bound, the bound counts as 0. *)
}

type 'r judgement =
  | Found of 'r  (** the search ends at this place with this result *)
  | Follow of { edge : int -> bool; flow : int -> bool }
  (** The search goes on to the targets that pass. From a start inside a flow only the flow counts. *)

type 'r found = { steps : step list; last : int; result : 'r }

type region
(** The places that a search without a result has met. *)

val search :
  Timed_graph.t ->
  ?by_time:bool ->
  ?bound:Rat.t ->
  Positions.position ->
  (place -> 'r judgement) ->
  ('r found, region) result
(** [search g ~by_time ~bound start judge] is a breadth-first search, so that its result has the fewest steps.
    [judge] is called once for each node, or with [by_time] once for each node and time at which it is met. *)

val lasso : region -> prefer:(Timed_graph.move -> bool) -> t option
(** [lasso region ~prefer] is a run along the ways of the search that ends in a cycle. The cycle contains the first
    move that passes [prefer] and lies on a cycle, or else the first move on any. It is [None] if there is no
    cycle. *)

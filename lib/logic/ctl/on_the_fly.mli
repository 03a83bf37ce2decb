(** Questions about all the runs of a timed transition system, answered while it is explored. The system is
    abstract: what holds where is judged by functions that come with each question. *)

open Scc_exact
open Scc_graph_search

(** A predicate on the instants of runs. The tuples that are asked about are not kept. *)
type predicate = {
  at : int array -> Truth.t;  (** in a state *)
  along : (int array -> Timeline.extent -> Truth.t Timeline.t) option;
  (** along the trajectory that starts in a state; [None] when it is what it is at the start *)
}

(** Of a goal along a trajectory, what a search asks: the first moments after the start at which it holds for
    certain, and at which it holds or cannot be decided. *)
type phases = {
  surely : Timeline.moment option;
  perhaps : Timeline.moment option;
  why : string option;  (** of what cannot be decided *)
}

val phases : Truth.t Timeline.t -> phases

module Make (L : Lts.S) (Graph : module type of Explore.Make (L)) : sig
  (** Does some run meet the goal: EF. *)
  type question = {
    within : Rat.t option;  (** only the instants in [0, b] count *)
    goal : predicate;
  }

  (** Where a trace leads after its steps. *)
  type finish =
    | At_state  (** to its last state *)
    | During of { choice : int option; moment : Timeline.moment; sample : Algebraic.t }
    (** to a moment in the middle of the time transition of this choice (of the ray of the last state,
        when [None]); the sample is an offset at which the goal's value is the one met *)
    | Repeats of int  (** back to the state before the step of this index, for ever *)

  type trace = { steps : Graph.step list; last : int; finish : finish }

  (** Why there is no answer; not both empty. *)
  type doubts = {
    unexplored : int Seq.t;  (** the states that were not expanded and could matter *)
    undefined : string option;  (** the goal could not be decided somewhere where it matters *)
  }

  type answer =
    | Met of trace  (** by this run: with the fewest steps, or the earliest when there is a bound of time *)
    | Never  (** the whole of what counts was explored *)
    | Open of doubts

  type result = {
    graph : Graph.t;
    answers : answer list;  (** in the order of the questions *)
    zeno : trace option;  (** a reachable cycle without duration, whatever was asked *)
  }

  val run :
    ?observe:(Graph.t -> int -> int array -> unit) ->
    ?order:Graph.order ->
    ?keep_edges:bool ->
    ?expanding:Graph.expanding ->
    ?settled:(Graph.t -> bool) ->
    rests:(int array -> bool) ->
    Limits.t ->
    Limits.surroundings ->
    L.context ->
    question list ->
    result
    (** [rests] says of a state without transitions whether time passes there for ever. [observe] is called with
        each new state. [settled] says whether what else is asked has an answer that will stay; it is asked each
        time that the graph has doubled. The exploration ends as soon as everything is answered, when anything is
        asked. *)
end

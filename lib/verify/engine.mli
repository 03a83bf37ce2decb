(** Questions about all the runs of a timed transition system, answered while it is explored. The system is
    abstract: what holds where is judged by functions that come with each question. *)

open Scc_exact
open Scc_explore

(** A predicate on the instants of runs. *)
type predicate = {
  at : int array -> Truth.t;  (** in a state *)
  along : (int array -> Timeline.extent -> Truth.t Timeline.t) option;
  (** along the trajectory that starts in a state; [None] when it is what it is at the start *)
}

module Make (L : Lts.S) : sig
  module Graph : module type of Explore.Make (L)

  type operator =
    | Reach  (** some run meets the goal at some instant: EF *)
    | Inevitable  (** every run does: AF. No fairness is assumed. *)

  type question = {
    operator : operator;
    within : Rat.t option;  (** only the instants in [0, b] count *)
    goal : predicate;
  }

  (** Where a trace leads after its steps. *)
  type finish =
    | At_state  (** to its last state *)
    | During of { choice : int option; moment : Timeline.moment; sample : Algebraic.t }
    (** to a moment in the middle of the time transition of this choice (of the ray of the last state,
        when [None]); the sample is an offset at which the goal's value is the one met *)
    | Rests  (** the ray of the last state, all of it *)
    | Stops  (** nothing: the run is over, and no time passes any more *)
    | Repeats of int  (** back to the state before the step of this index, for ever *)
    | Passes of int option
    (** past the bound of time in the middle of this choice, or of the ray *)

  type trace = { steps : Graph.step list; last : int; finish : finish }

  (** Why there is no answer. *)
  type doubt =
    | Truncated of L.fault Explore.reason
    (** states were not expanded, for this reason, that could matter *)
    | Undefined of string  (** the goal could not be decided somewhere where it matters *)
    | Zeno of trace  (** a run that goes on for ever within one instant *)

  type answer =
    | Yes of trace option  (** with a run that meets the goal, for [Reach] *)
    | No of trace option
    (** with a run that avoids it, for [Inevitable]; for [Reach], the whole of what counts was explored *)
    | Unknown of doubt list  (** not empty *)

  type result = {
    graph : Graph.t;
    answers : answer list;  (** in the order of the questions *)
    zeno : trace option;  (** a reachable cycle without duration, whatever was asked *)
  }

  val run :
    ?observe:(Graph.t -> int -> int array -> unit) ->
    ?keep_edges:bool ->
    rests:(int array -> bool) ->
    Limits.t ->
    Limits.surroundings ->
    L.context ->
    question list ->
    result
  (** [rests] says of a state without transitions whether time passes there for ever. [observe] is called with each new
      state. The exploration ends as soon as every question is answered (when there is one); when all of them have a
      bound of time, it does not go past the greatest. *)

  val horizon : Limits.t -> question list -> Rat.t option
  (** The bound of time that {!run} explores up to. *)
end

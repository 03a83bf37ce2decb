(** Reachability on the fly: questions about the runs of a timed transition system, answered during its
    exploration. The system is abstract; each question has functions for the truth of its goal. *)

open Scc_exact
open Scc_graph_search

(** A predicate on the instants of runs. Its functions must not keep the tuples that they get. *)
type predicate = {
  at : int array -> Truth.t;  (** the truth in a state *)
  along : (int array -> Timeline.extent -> Truth.t Timeline.t) option;
  (** The truth along the trajectory that starts in a state; [None] if it is constant along trajectories. *)
}

(** The first moments of a goal along a trajectory, after its start. *)
type phases = {
  surely : Timeline.moment option;  (** the first moment at which the goal holds *)
  perhaps : Timeline.moment option;  (** the first moment at which the goal holds or is undecided *)
  why : string option;  (** the reason, if it is undecided at [perhaps] *)
}

val phases : Truth.t Timeline.t -> phases
(** [phases timeline] is the first moments of the goal with this truth along a trajectory. *)

val is_in_time : Rat.t option -> arrival:Rat.t -> Timeline.moment -> bool
(** [is_in_time within ~arrival moment] is true if a moment after a state that is reached at the time [arrival]
    counts for a question with the bound [within]. *)

val sample_in_time : Rat.t option -> arrival:Rat.t -> Timeline.moment -> Algebraic.t -> Algebraic.t
(** [sample_in_time within ~arrival moment sample] is the sample of such a moment ({!Timeline.sample}), or an
    earlier one: an open piece may go on beyond the bound. *)

module Make (L : Lts.S) (Graph : module type of Explore.Make (L)) : sig
  (** The question if some run meets the goal: EF. *)
  type question = {
    within : Rat.t option;  (** with [Some b], only the instants in [0, b] count *)
    goal : predicate;
  }

  (** The end of a trace after its steps. *)
  type finish =
    | At_state  (** to its last state *)
    | During of { choice : int option; moment : Timeline.moment; sample : Algebraic.t }
    (** to a moment within the time transition of this choice, or within the ray of the last state for [None]. At
        the offset [sample] the goal has the truth that was met. *)
    | Repeats of int  (** back to the state before the step of this index, for ever *)

  type trace = { steps : Graph.step list; last : int; finish : finish }

  (** The reasons for no answer; not both are empty. *)
  type doubts = {
    unexplored : int Seq.t;  (** the states that were not expanded and could matter *)
    undefined : string option;  (** the reason why the goal is undecided at an instant that matters *)
  }

  type answer = | Met of trace  (** this run meets the goal: with the fewest steps, or the earliest if there is a
                                    bound of time *)
                | Never  (** no run meets the goal: all that counts was explored *)
                | Open of doubts

  type result = {
    graph : Graph.t;
    answers : answer list;  (** in the order of the questions *)
    zeno : trace option;  (** a reachable cycle without duration, whatever the questions are *)
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
    (** [run ~rests limits surroundings context questions] explores the system and answers the questions. [rests
        tuple] is true if time passes for ever in a state without transitions. [observe] is called with each new
        state. [settled] is true if all other questions about the graph have final answers; it is called each time
        the graph has doubled. If there is any question, the exploration ends once all are answered. *)
end

(** The graph of the states that an exploration has found: its tables, and what can be asked of them. The modules
    that build it stand on each other: this one, {!Ahead}, {!Growing}, {!Linked}, {!Explore}. Each includes the one
    before, and {!Explore} alone hides the tables. *)

open Scc_exact

module Make (L : Lts.S) : sig
  (** A transition of a state. *)
  type edge = { label : int; target : int }

  (** A step of a path: the choice (an index into the edges) made at a state. *)
  type step = { source : int; choice : int }

  (** The order in which states are expanded: in which they are found, or by their earliest arrivals. *)
  type order = By_steps | By_time

  (** Where cycles without duration may be: through one of these states, or nothing is known. *)
  type turning = At of Scc_data.Int_vector.t | Anywhere

  (** The tables of a graph. States are numbered from 0 in the order in which they are found. *)
  type t = {
    context : L.context;
    order : order;
    tuples : Tuples.t;
    near : Tuples.spread;  (** the state being expanded *)
    reader : Tuples.spread;  (** the state that was read last *)
    distances : Distances.t;
    statuses : L.fault Statuses.t;
    frontier : Frontier.t;
    edges : Edge_store.t option;  (** none if edges are made anew when they are asked for *)
    at_once : Edges_at_once.t;
    mutable targets : int array;  (** of the state being expanded, and room for more *)
    mutable labels : int array;  (** the same, where other processes have found its edges *)
    mutable transitions : int;  (** of all states that are expanded *)
    mutable turning : turning;
    timed : Timed_labels.t;
    mutable shared : Shared_states.t option;  (** what other processes see of them *)
  }

  (** {1 For the modules that build it} *)

  val make_room_for_targets : t -> int -> unit
  (** [make_room_for_targets g count] gives [targets] and [labels] room for so many edges. *)

  val may_turn : t -> bool
  (** [may_turn g] is true if there may be cycles without duration. *)

  val takes_time : t -> int -> bool
  (** [takes_time g label] is true if transitions of this label have a duration. *)

  val transitions_of : t -> int -> int
  (** [transitions_of g label] is {!Lts.S.transitions} of the label. *)

  val is_ahead : t -> Lts.step -> bool
  (** [is_ahead g step] is true if a step of the state in [near], which is to be expanded, leads to another state
      that is not expanded yet, but will be. *)

  (** {1 What can be asked of it}

      Each function that {!Explore} has as well is explained there. *)

  val context : t -> L.context
  (** The context of the system. *)

  val size : t -> int
  (** The number of states. *)

  val tuple : t -> int -> int array
  (** The tuple of a state, as a new array. *)

  val read_tuple : t -> int -> int array -> unit
  (** Puts the tuple of a state into an array of its length. *)

  val depth : t -> int -> int
  (** The least number of transitions from the initial state. *)

  val arrival : t -> int -> Rat.t
  (** The least model time from the initial state. *)

  val greatest_depth : t -> int
  (** The greatest depth of a state. *)

  val greatest_arrival : t -> Rat.t
  (** The greatest arrival of a state. *)

  val transitions : t -> int
  (** The number of edges of all expanded states. *)

  val turning : t -> turning
  (** Where cycles without duration may be. *)

  val duration : t -> edge -> Rat.t
  (** The model time that an edge takes. *)

  val status : t -> int -> L.fault Statuses.status
  (** The status of a state. *)

  val is_expanded : t -> int -> bool
  (** [is_expanded g i] is true if the transitions of state [i] are known. *)

  val unexpanded : t -> (int * L.fault Statuses.reason) Seq.t
  (** The states that are not expanded and not queued, with the reasons. *)

  val left : t -> int
  (** The number of states that are not expanded. *)

  val left_for : t -> L.fault Statuses.reason -> int
  (** The number of states that are not expanded for this reason. *)

  val complete : t -> bool
  (** [complete g] is true if every state is expanded. *)

  val edges : t -> int -> edge array
  (** The edges of a state; none while it is not expanded. *)

  val edges_at_once : t -> int -> (int * int) list
  (** The edges of a state without duration: their indices and targets. *)

  val passing : t -> int -> Rat.t option
  (** The duration of the first edge of a state that takes time. *)

  val targets : t -> timed:bool -> int -> int array
  (** The targets of the edges of a state that take time, or of the others. *)

  val ancestors : t -> int -> int list
  (** The states of a shortest path from the initial state. *)

  val before : t -> int -> int option
  (** The state before this one in a shortest path. *)

  val shortest_path : t -> int -> step list
  (** A path with the fewest transitions. *)

  val earliest_path : t -> int -> step list
  (** A path in the least model time. *)

  (** The memory of a graph, in bytes: for tuples, for distances and statuses, and for edges. *)
  type memory = { states : int; labels : int; edges : int }

  val memory : t -> memory
  (** About how much memory the graph takes. *)
end

(** Exploration of a timed transition system, breadth-first or in the order of time. It is deterministic: equal
    systems and bounds give equal graphs, unless a clock, the memory or an interruption ends it. States take
    about 20 bytes each and edges 8. A graph that keeps no edges computes them again when they are needed. *)

open Scc_exact

(** Why a state has not been expanded. *)
type 'fault reason = 'fault Statuses.reason =
  | Depth  (** beyond the bound on transitions *)
  | Time  (** beyond the bound on model time *)
  | Instant  (** beyond the bound on transitions within one instant *)
  | States  (** the bound on the number of states was met *)
  | Bits  (** it has a number that is too long *)
  | Seconds  (** the exploration ended for its time *)
  | Memory  (** the exploration ended for its memory *)
  | Interrupted  (** the exploration was interrupted *)
  | Stopped  (** the visitor ended the exploration, or the state does not matter *)
  | Fault of 'fault  (** its transitions cannot be computed *)

type 'fault status = 'fault Statuses.status =
  | Expanded
  | Queued  (** only while the exploration goes on *)
  | Unexpanded of 'fault reason

val of_stop : Limits.stop -> 'fault reason
(** [of_stop stop] is the reason for the states that are left when [stop] ends an exploration. *)

module Make (L : Lts.S) : sig
  type t
  (** A graph. States are numbered from 0, the initial one, in the order in which they are found. *)

  type edge = { label : int; target : int }

  (** The callbacks of an exploration. Each is called once the graph shows the event. *)
  type visitor = {
    found : t -> int -> int array -> unit;  (** a new state, with its tuple *)
    opened : (t -> int -> int array -> edge array -> unit) option;
    (** A state has been expanded: its number, tuple and edges, whose targets are all found. It is not called
        when edges are computed again. *)
    earlier : t -> int -> unit;  (** an earlier arrival at a known state *)
    enough : unit -> bool;  (** called before each expansion: [true] ends the exploration *)
    matters : Rat.t -> bool;
    (** It is true if a state that is reached at this time, and no earlier, has to be expanded. Once it is false
        for a time, it stays false. *)
    dull : int array -> bool;
    (** If it is true of the tuple of a new state, [found] does nothing for it, then or later. It may be called
        in any process, and for states that never come to be found. *)
  }

  val blind : visitor
  (** The visitor that does nothing: all states matter, and it is told of all. *)

  (** The order in which states are expanded. *)
  type order =
    | By_steps  (** in the order in which they are found: breadth-first *)
    | By_time  (** by their earliest arrivals, then in the order in which they are found *)

  (** {1 The source of transitions} *)

  (** An edge of a state that is expanded: to a new state, or to one that is known by then. *)
  type arrow = New of Lts.step | Known of edge

  type steps = { steps : Lts.step list; reduced : bool  (** further transitions are postponed *) }

  (** The edges of a state that change something, in order, with the number of all its edges. *)
  type noted = { arrows : arrow list; count : int; reduced : bool  (** further transitions are postponed *) }

  (** The result of an expansion: the transitions of a state. For a state that was expanded before in the same
      graph, it may be only what was noted of them. *)
  type expansion = Found of steps | Noted of noted

  (** The receiver of the results of one state that was expanded completely. *)
  type told = {
    asks : int -> bool;
    (** [asks label] is true if edges of this label are passed on even if they lead to known states and have
        changed nothing. All other edges are passed on. *)
    tell : int -> noted -> unit;  (** [tell i noted] gets the state, and the edges that are passed on. *)
  }

  (** What {!put_answer} has put of a state, from this place on. *)
  type answer = { words : Answers.words; at : int }

  (** The way in which transitions of states are computed. The graph does not depend on it. *)
  type expander = {
    ready : int -> answer option;
    (** What has been found of a state already, if anything. It is called before {!expand}, within an attempt,
        once the graph has been shared. *)
    expand : int -> int array -> (expansion, L.fault) result;
    (** The transitions of a state, given its number and its tuple. It is called within an attempt, which may be
        given up at any point. *)
    expanded : unit -> told option;  (** called after {!expand}: the receiver of the results, if any *)
    finish : unit -> unit;  (** called at the end of the exploration, also after an exception *)
  }

  type expanding =
    t -> all_edges:bool -> waits:(int -> bool) -> room:(unit -> int) -> dull:(int array -> bool) -> expander
  (** The expander of an exploration that begins. With [all_edges] all edges are kept or visited, also those that
      change nothing. [waits i] is true if state [i] is queued and within the bounds at present, and has not been
      taken up again by steps. [room ()] is how many states there may come to be, by the bound on states;
      [max_int] without one. [dull] is that of the visitor. *)

  val here : expanding
  (** The expander that calls {!successors} in this process. *)

  val successors : t -> int array -> (steps, L.fault) result
  (** [successors g tuple] is the result that [expand] of an expander must find. It is the reduced transitions of
      the tuple ({!Lts.S.reduced}) if one of them leads to another state that is not expanded yet, but will be,
      and otherwise all transitions. *)

  val run :
    ?visitor:visitor -> ?order:order -> ?keep_edges:bool -> ?expanding:expanding ->
    Limits.t -> Limits.surroundings -> L.context -> t
  (** [run limits surroundings context] explores the system until no state within the bounds is left, or a bound
      on the resources is met, or [visitor] ends it. The order is [By_steps] by default, and edges are kept by
      default. *)

  (** {1 Processes that share a graph} *)

  val share : t -> Common.t option
  (** [share g] moves the tables of the graph into memory that is shared with processes that are forked from now
      on. They call {!put_answer}; all else is left to this process. The result is the table of texts; [None] if
      the system gives no such memory, and then the graph stays with this process. *)

  val unshare : t -> unit
  (** [unshare g] moves the tables back to this process alone. No other process may use the graph any more. *)

  val shared_bytes : t -> int
  (** [shared_bytes g] is about how much memory is shared, in bytes. *)

  val put_answer : t -> all_edges:bool -> dull:(int array -> bool) -> Answers.words -> int -> int -> int
  (** [put_answer g ~all_edges ~dull words at i] finds the transitions of state [i] of a graph that is shared,
      and their targets as far as they are known, and puts both into [words] from [at] on. Without [all_edges],
      edges that change nothing may be left out. The result is the first place that is free after that. Where the
      transitions are best found by the process that numbers states, this is noted in their place. It raises
      {!Answers.Too_long} if there is no room. *)

  val fetch : t -> answer -> unit
  (** [fetch g answer] looks up what is asked for once the state of the answer is expanded, so that this is fast.
  *)

  val refresh : t -> Common.t -> unit
  (** [refresh g common] is called before {!put_answer} by a process that has not worked for a while. *)

  val is_room_wanted : t -> Common.t -> bool
  (** [is_room_wanted g common] is true if {!make_room} should be called soon. *)

  val make_room : t -> Common.t -> unit
  (** [make_room g common] enlarges what is full of the tables. No other process may use them meanwhile. *)

  val go_on_apart : t -> Common.t -> full:(unit -> unit) -> unit
  (** [go_on_apart g common ~full] is called by a process that has been forked, before {!put_answer}. [full] is
      as for {!set_full}. *)

  val set_full : t -> Common.t -> (unit -> unit) -> unit
  (** [set_full g common full]: this process calls [full] where something does not fit the tables. It calls
      {!make_room}, or raises. *)

  val context : t -> L.context
  (** [context g] is the context given to {!run}. *)

  val size : t -> int
  (** [size g] is the number of states. *)

  val tuple : t -> int -> int array
  (** [tuple g i] is the tuple of state [i], as a new array. *)

  val read_tuple : t -> int -> int array -> unit
  (** [read_tuple g i room] puts the tuple of state [i] into an array of its length, so that reading many states
      allocates nothing. *)

  val status : t -> int -> L.fault status
  (** [status g i] is the status of state [i]. *)

  val edges : t -> int -> edge array
  (** [edges g i] is the edges of state [i], in the order of {!Lts.S.successors}; empty while it is not expanded.
  *)

  val edges_at_once : t -> int -> (int * int) list
  (** [edges_at_once g i] is the edges of state [i] without duration: for each its index among {!edges}, and its
      target. *)

  val targets : t -> timed:bool -> int -> int array
  (** [targets g ~timed i] is the targets of the edges of state [i] that take time, or of those that take none,
      in order. *)

  val passing : t -> int -> Rat.t option
  (** [passing g i] is the duration of the first edge of state [i] that takes time. *)

  val duration : t -> edge -> Rat.t
  (** [duration g e] is the model time that the edge takes; 0 for a discrete transition. *)

  val transitions : t -> int
  (** [transitions g] is the number of edges of all expanded states. *)

  (** Where cycles without duration may be. *)
  type turning =
    | At of Scc_data.Int_vector.t  (** each such cycle leads through one of these states *)
    | Anywhere  (** nothing is known of their places *)

  val turning : t -> turning
  (** [turning g] is where cycles without duration may be. *)

  val depth : t -> int -> int
  (** [depth g i] is the least number of transitions from the initial state to [i], in the explored graph. *)

  val arrival : t -> int -> Rat.t
  (** [arrival g i] is the earliest arrival: the least model time from the initial state to [i], in the explored
      graph. *)

  val greatest_depth : t -> int
  (** [greatest_depth g] is the greatest {!depth} of a state, in linear time. *)

  val greatest_arrival : t -> Rat.t
  (** [greatest_arrival g] is the greatest {!arrival} of a state, in linear time. *)

  val unexpanded : t -> (int * L.fault reason) Seq.t
  (** [unexpanded g] is the states that are not expanded, in order, with the reasons. It may have millions of
      elements. States that are still queued are left out. *)

  val left : t -> int
  (** [left g] is the number of states that are not expanded, in constant time. *)

  val left_for : t -> L.fault reason -> int
  (** [left_for g reason] is the number of states that are not expanded for this reason, in constant time. All
      faults count together. *)

  val complete : t -> bool
  (** [complete g] is true if every state is expanded. *)

  (** A step of a path: the choice (an index into the edges) made at a state. *)
  type step = { source : int; choice : int }

  val ancestors : t -> int -> int list
  (** [ancestors g i] is the states of [shortest_path g i], from the initial state to [i], both included. *)

  val before : t -> int -> int option
  (** [before g i] is the state before [i] in [ancestors g i]; [None] for the initial state. *)

  val shortest_path : t -> int -> step list
  (** [shortest_path g i] is a path from the initial state to [i] with the fewest transitions. *)

  val earliest_path : t -> int -> step list
  (** [earliest_path g i] is a path from the initial state to [i] in the least model time. *)

  (** The memory of a graph, in bytes: for tuples, for distances and statuses, and for edges. *)
  type memory = { states : int; labels : int; edges : int }

  val memory : t -> memory
  (** [memory g] is about how much memory the graph takes. *)
end

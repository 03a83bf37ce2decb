(** Breadth-first exploration of a timed transition system. Deterministic: the same system and bounds give the same
    graph, unless a clock, the memory or an interruption ends it. States take about 20 bytes each and edges 8;
    without its edges, a graph makes them anew when they are asked for. *)

open Scc_exact

(** Why a state has not been expanded. *)
type 'fault reason = 'fault Statuses.reason =
  | Depth
  | Time
  | Instant
  | States
  | Bits
  | Seconds
  | Memory
  | Interrupted
  | Stopped  (** the visitor had seen enough *)
  | Fault of 'fault  (** its transitions cannot be computed *)

type 'fault status = 'fault Statuses.status =
  | Expanded
  | Queued  (** only while the exploration goes on *)
  | Unexpanded of 'fault reason

val of_stop : Limits.stop -> 'fault reason

module Make (L : Lts.S) : sig
  type t
  (** A graph. States are numbered from 0, the initial one, in the order in which they are found. *)

  type edge = { label : int; target : int }

  (** Who is told what is found, each once the graph shows it. *)
  type visitor = {
    found : t -> int -> int array -> unit;  (** a new state, with its tuple *)
    opened : (t -> int -> int array -> edge array -> unit) option;
    (** a state has been expanded: its tuple and edges, whose targets are all found. Not when the edges are made
        anew *)
    earlier : t -> int -> unit;  (** a shorter time to a known state *)
    enough : unit -> bool;  (** asked before each expansion: whether to stop *)
    matters : Rat.t -> bool;
    (** whether a state that is reached at this time, and no earlier, has to be expanded; once it has not, it never
        has *)
  }

  val blind : visitor

  (** The order in which states are expanded. *)
  type order =
    | By_steps  (** those found first first: breadth-first *)
    | By_time  (** by their earliest arrivals, then as found *)

  (** {1 Where transitions come from} *)

  (** An edge of a state that is expanded: to one that is new, or to one that is there by then. *)
  type arrow = New of Lts.step | Known of edge

  type steps = { steps : Lts.step list; reduced : bool  (** there are more, which will do later *) }

  (** What is found at a state: its transitions, or, where it was expanded before in the same graph, those
      that change anything, and how many there are. *)
  type expansion = Found of steps | Noted of { arrows : arrow list; count : int }

  (** Who is told what came of a state that was expanded and looked at to the end. *)
  type told = {
    asks : int -> bool;
    (** whether edges of this label are told that lead to known states and have not changed anything; others are *)
    tell : int -> count:int -> arrow list -> unit;  (** the state, how many edges it has, and those, in order *)
  }

  (** Who finds the transitions of states. What a graph is does not depend on it. *)
  type expander = {
    expand : int -> int array -> (expansion, L.fault) result;
    (** of a state and its tuple. Called within an attempt, which may be given up wherever it is *)
    expanded : unit -> told option;  (** asked after {!expand}: who wants to know what comes of it *)
    finish : unit -> unit;  (** at the end, whatever that is *)
  }

  type expanding = t -> all_edges:bool -> waits:(int -> bool) -> expander
  (** Of an exploration that begins. [all_edges]: edges are kept or looked at, also those that change nothing.
      [waits i]: whether the state is to be expanded as far as can be told now. *)

  val here : expanding
  (** By {!successors}. *)

  val successors : t -> int array -> (steps, L.fault) result
  (** What {!expander.expand} is to find: the reduced transitions of a tuple if all of them lead to states that are
      not known, and else all. *)

  val all_or_some :
    t -> some:Lts.step list option -> all:(unit -> (Lts.step list, L.fault) result) -> (steps, L.fault) result
  (** The same of the state that is expanded, when both are known. *)

  val run :
    ?visitor:visitor -> ?order:order -> ?keep_edges:bool -> ?expanding:expanding ->
    Limits.t -> Limits.surroundings -> L.context -> t
  (** Explores until nothing is left to expand within the bounds, or a bound on the resources is met, or
      the visitor has seen enough. Edges are kept unless told otherwise. *)

  val context : t -> L.context
  val size : t -> int
  val tuple : t -> int -> int array

  val read_tuple : t -> int -> int array -> unit
  (** Puts the {!tuple} into an array as long as it, for who asks about many states and keeps none. *)

  val status : t -> int -> L.fault status

  val edges : t -> int -> edge array
  (** In the order of {!Lts.S.successors}; empty while the state is not expanded. *)

  val edges_at_once : t -> int -> (int * int) list
  (** The places among the {!edges} of those without duration, each with its target. *)

  val targets : t -> timed:bool -> int -> int array
  (** Those of the edges of a state that take time, or of those that take none, in order. *)

  val passing : t -> int -> Rat.t option
  (** The duration of the first edge of a state that takes time. *)

  val duration : t -> edge -> Rat.t

  val transitions : t -> int
  (** The number of edges. *)

  (** Where cycles may be along which no time passes. *)
  type turning =
    | At of Scc_data.Int_vector.t  (** each of them leads through one of these states *)
    | Anywhere

  val turning : t -> turning

  val depth : t -> int -> int
  (** The least number of transitions from the initial state. *)

  val arrival : t -> int -> Rat.t
  (** The earliest arrival: the least model time from the initial state. Both are exact with respect to
      the explored graph. *)

  val greatest_depth : t -> int
  val greatest_arrival : t -> Rat.t

  val unexpanded : t -> (int * L.fault reason) Seq.t
  (** In the order of states, and there may be millions; states that are still queued are left out. *)

  val left : t -> int
  (** How many states are unexpanded; answered at once, as {!left_for} is. *)

  val left_for : t -> L.fault reason -> int
  (** How many are for this reason; for any fault, where it is one. *)

  val complete : t -> bool
  (** Every state is expanded. *)

  (** A step of a path: the choice (an index into the edges) made at a state. *)
  type step = { source : int; choice : int }

  val ancestors : t -> int -> int list
  (** The states of the path of {!shortest_path}, with the state itself. *)

  val shortest_path : t -> int -> step list
  (** From the initial state, with the fewest transitions. *)

  val earliest_path : t -> int -> step list
  (** From the initial state, in the least model time. *)

  (** What the graph takes, in bytes. *)
  type memory = { states : int; labels : int; edges : int }

  val memory : t -> memory
end

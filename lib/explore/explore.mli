(** Breadth-first exploration of a timed transition system into an explicit graph. Deterministic: the same
    system and bounds give the same graph, unless a clock, the memory or an interruption ends it. *)

open Scc_exact

(** Why a state has not been expanded. *)
type 'fault reason =
  | Depth
  | Time
  | Instant
  | States
  | Seconds
  | Memory
  | Interrupted
  | Stopped  (** the visitor had seen enough *)
  | Fault of 'fault  (** its transitions cannot be computed *)

module Make (L : Lts.S) : sig
  type t
  (** A graph. States are numbered from 0, the initial one, in the order in which they are found. *)

  type edge = { transition : L.transition; target : int }

  type status =
    | Expanded
    | Queued  (** only while the exploration goes on *)
    | Unexpanded of L.fault reason

  (** What a visitor is told; each is sent once the graph shows it. *)
  type event =
    | Found of int  (** a new state *)
    | Opened of int  (** the state has been expanded: its edges are known, and all their targets found *)
    | Earlier of int  (** a shorter time to a known state *)

  type decision = Continue | Stop

  val run :
    ?visit:(t -> event -> decision) -> Limits.t -> Limits.surroundings -> L.context -> t
  (** Explores until nothing is left to expand within the bounds, or a bound on the resources is met, or
      the visitor stops it. *)

  val size : t -> int
  val state : t -> int -> L.state
  val find : t -> L.state -> int option
  val status : t -> int -> status

  val edges : t -> int -> edge array
  (** In the order of {!Lts.S.successors}; empty while the state is not expanded. *)

  val transitions : t -> int
  (** The number of edges. *)

  val depth : t -> int -> int
  (** The least number of transitions from the initial state. *)

  val arrival : t -> int -> Rat.t
  (** The earliest arrival: the least model time from the initial state. Both are exact with respect to
      the explored graph. *)

  val greatest_depth : t -> int
  val greatest_arrival : t -> Rat.t

  val unexpanded : t -> (int * L.fault reason) list
  (** In the order of states; states that are still queued are not listed. *)

  val complete : t -> bool
  (** Every state is expanded. *)

  (** A step of a path: the choice (an index into the edges) made at a state. *)
  type step = { source : int; choice : int }

  val shortest_path : t -> int -> step list
  (** From the initial state, with the fewest transitions. *)

  val earliest_path : t -> int -> step list
  (** From the initial state, in the least model time. *)

  val replay : L.context -> int list -> (L.transition list, int * L.fault option) result
  (** Follows a list of choices from the initial state: the transitions made, or the index of the choice
      that does not fit, with the fault if the state's transitions could not be computed. *)
end

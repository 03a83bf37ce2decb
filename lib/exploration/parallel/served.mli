(** What a worker of a {!Crew} does: it finds the transitions of states that another process numbers. Requests
    and answers lie in memory that they share. *)

open Scc_graph_search

(** Memory for a request and its answers. *)
type slot = Scc_shared.Shared_memory.numbers

val request : slot -> int array -> unit
(** [request slot states] asks for the transitions of some states. *)

val answered : slot -> int
(** [answered slot] is the number of states that have been seen to, the first ones of the request; negative while
    it is under way. *)

(** How far the answer about a state is. *)
type progress =
  | Free  (** nobody has begun with it *)
  | Taken  (** a process is at it, or has it for itself *)
  | Untold  (** it was left to the process that numbers states *)
  | Answered of int  (** the answer is at this place *)

val progress : slot -> int -> progress
(** [progress slot k] is how far the answer about the [k]-th state is, from 0, also while the request is under
    way. *)

val take : slot -> int -> bool
(** [take slot k] is true if the [k]-th state was {!Free}. Now it is {!Taken} by this process, and no other one
    finds its transitions. *)

val seconds : slot -> float
(** [seconds slot] is how long the answers took. *)

(** Memory in which the two processes say that they wait for a message. *)
type bells

val bells : unit -> bells option
(** [bells ()] is new bells; [None] if the system gives no memory. *)

val say_waiting : bells -> int -> unit
(** [say_waiting bells who] is called by a process before it looks once more for what it waits for, and then
    waits for a message. *)

val is_waiting : bells -> int -> bool
(** [is_waiting bells who] is true if a process waits for a message, once for each time. It is called after
    something was written for that process. *)

val is_paused : bells -> bool
(** [is_paused bells] is true if the worker has stopped in the midst of a request, until {!end_pause}, as room is
    wanted in the tables. *)

val end_pause : bells -> unit
(** [end_pause bells] lets it go on. It may have to be woken. *)

val main : int
(** The process that numbers the states, for {!say_waiting} and {!is_waiting}. *)

val worker : int
(** The other process. *)

module Make (L : Lts.S) (Graph : module type of Explore.Make (L)) : sig
  (** A graph that is shared, with its table of texts; whether all edges are wanted; and the states of which a
      visitor is not told. *)
  type shared = { graph : Graph.t; common : Common.t; all_edges : bool; dull : int array -> bool }

  val find_for : shared -> slot -> seconds:float -> unit
  (** [find_for shared slot ~seconds] answers the request in a slot: for each state in turn what
      {!Graph.put_answer} puts. It ends early where the slot is full, or room is wanted in the tables, and before
      the next state once these seconds are over. *)

  val serve : shared -> slot array -> bells -> Channel.t -> unit
  (** [serve shared slots bells channel] answers the requests that come into the slots by turns. It is called in
      another process. A message wakes it, where it waits, and its messages tell how many words of memory it has.
      It ends with {!Channel.Closed}. *)
end

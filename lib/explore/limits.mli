(** How far an exploration goes, and how it talks to its surroundings. *)

open Scc_exact

(** Each bound is off when [None]. A state is expanded iff its least depth and its earliest arrival are
    within the bounds, whatever the order in which paths to it are found. *)
type t = {
  depth : int option;  (** greatest number of transitions from the initial state to an expanded state *)
  time : Rat.t option;  (** greatest earliest arrival, in model time, of an expanded state *)
  instant : int option;
  (** greatest number of transitions without passing time that a path to an expanded state ends in: the
      guard against a run that goes on for ever within one instant *)
  states : int option;  (** greatest number of states kept *)
  seconds : float option;  (** of the clock below *)
  memory : int option;  (** words of the heap of the whole program *)
}

val unlimited : t

type progress = {
  states : int;
  transitions : int;
  waiting : int;
  depth : int;
  model_time : Rat.t;  (** the earliest arrival in the state that is looked at *)
}

(** Does something that may take long and does not look at the clock; [None] when it was given up. *)
type attempt = { run : 'a. (unit -> 'a) -> 'a option }

type surroundings = {
  now : unit -> float;  (** a clock in seconds; only differences count *)
  interrupted : unit -> bool;
  progress : progress -> unit;  (** called now and then *)
  ended : unit -> unit;  (** called when an exploration is over: what is made of it takes its time *)
  attempt : attempt;
}

val quiet : surroundings
(** A clock that stands still, no interruption, no progress shown, and nothing given up. *)

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
  bits : int option;  (** greatest length of a number in an expanded state *)
}

val unlimited : t

val too_long : t -> longest:int -> bits:(unit -> int) -> bool
(** Whether a state of so many [bits] is not to be expanded, where no number so far is longer than [longest]. *)

type progress = {
  states : int;
  transitions : int;
  waiting : int;
  depth : int;
  model_time : Rat.t;  (** the earliest arrival in the state that is looked at *)
}

(** Why work is to end that has more to do: the seconds are over, the memory is used up, or somebody wants it. *)
type stop = Seconds | Memory | Interrupted

(** What work is part of. What concludes has a little more time and memory than what explores or looks for a proof,
    and what reports a little more than that, so that something can always be told of what was explored. *)
type stage = Exploring | Proving | Concluding | Reporting

(** Does something that may take long, and does not ask whether it is to stop. It may be given up wherever it is,
    but in a {!Scc_base.Critical} section. *)
type attempt = { run : 'a. stage -> (unit -> 'a) -> ('a, stop) result }

type surroundings = {
  stop : unit -> stop option;  (** asked before each state *)
  half : unit -> surroundings;
  (** of work that begins now and may take half of the seconds that are left, for something to be done after it:
      where it explores or looks for a proof it is given up in the middle *)
  progress : progress -> unit;  (** called now and then *)
  attempt : attempt;
}

val quiet : surroundings
(** Nothing stops, no progress is shown, and nothing is given up. *)

exception Over of stop

val within : surroundings -> (unit -> 'a) -> 'a
(** An attempt of an exploration; {!Over} ends the exploration, at a state that was not looked at to the end. *)

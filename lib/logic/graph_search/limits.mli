(** The limits of an exploration, and its connection to its surroundings: progress, interruption, attempts. *)

open Scc_exact

(** Each bound is off when [None]. A state is expanded iff its least depth and its earliest arrival are
    within the bounds, whatever the order in which paths to it are found. *)
type t = {
  depth : int option;  (** the greatest number of transitions from the initial state to an expanded state *)
  time : Rat.t option;  (** the greatest earliest arrival, in model time, of an expanded state *)
  instant : int option;
  (** The greatest number of transitions without time at the end of a path to an expanded state. It guards against
      a run that goes on for ever within one instant. *)
  states : int option;  (** the greatest number of states kept *)
  bits : int option;  (** the greatest length of a number in an expanded state, in bits *)
}

val unlimited : t
(** No bounds. *)

val too_long : t -> longest:int -> bits:(unit -> int) -> bool
(** [too_long limits ~longest ~bits] is true if a state whose longest number has [bits ()] bits must not be
    expanded. No number so far is longer than [longest]; [bits] is called only if that exceeds the limit. *)

type progress =
  | Explored of {
      states : int;  (** states found so far *)
      transitions : int;  (** transitions found so far *)
      waiting : int;  (** states that wait to be expanded *)
      depth : int;  (** the depth of the present state *)
      model_time : Rat.t option Lazy.t;
      (** the earliest arrival at the present state, if states know their time *)
    }
  | Valued of { sets : int; all : int }
  (** After an exploration over ranges: so many sets of states have a value, of so many that are to have one. *)

(** The reason for work to end early: its seconds are over, its memory is used up, or it was interrupted. *)
type stop = Seconds | Memory | Interrupted

(** The stage of work. Conclusions have a little more time and memory than the exploration and the search for a
    proof, and reports a little more than that. So the explored part can always be reported. *)
type stage = Exploring | Proving | Concluding | Reporting

(** A way to run work that may take long and does not call [stop] itself. The work may be given up at any point
    outside of {!Scc_base.Critical} sections. *)
type attempt = { run : 'a. stage -> (unit -> 'a) -> ('a, stop) result }

type surroundings = {
  stop : unit -> stop option;  (** called before each state: the reason to end, if any *)
  half : unit -> surroundings;
  (** [half ()] is the surroundings of work that begins now and may take half of the seconds that are left, so that
      time is left for later work. Work that explores or searches for a proof is given up then. *)
  share : mine:int -> all:int -> surroundings;
  (** [share ~mine ~all] is the surroundings of work that begins now and may take [mine] of [all] parts of the
      seconds that are left, conclusions included. Exploring and searching for a proof have three quarters of that.
      [mine] is positive and less than [all]. *)
  progress : progress -> unit;  (** called now and then *)
  attempt : attempt;  (** runs work that may have to be given up *)
}

val undivided : ?stop:(unit -> stop option) -> ?attempt:attempt -> unit -> surroundings
(** Surroundings whose parts may take all that is left. No progress is shown. By default nothing stops, and no work
    is given up. *)

val quiet : surroundings
(** The surroundings in which nothing stops, no progress is shown, and no work is given up. *)

exception Over of stop
(** The exploration ends, for this reason. *)

val within : surroundings -> (unit -> 'a) -> 'a
(** [within surroundings f] is [f ()], run as an attempt in the stage [Exploring]. If the attempt is given up, it
    raises {!Over}, which ends the exploration at a state that was not completed. *)

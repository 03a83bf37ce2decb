(** Explanations why a formula holds at a position, or why it does not: trees with runs in them. *)

type t = {
  formula : Timed_formula.t;
  position : Positions.position;
  holds : bool;
  because : because;
}

and because =
  | Given  (** a predicate: no further reason *)
  | Parts of t list  (** for not, and, or: the parts that decide it *)
  | Run of { run : Run.t; way : way; parts : t list; along : along option }
  (** A run from the position decides it. [parts] explain its goal, and [along] its way. F and G are read as U. For
      X, the last step is the edge.

      If "f until g" holds on some run, g holds at the goal, and f before. If it does not hold on every run, either
      f does not hold at the goal, or the run is endless or goes past the bound. In both cases g does not hold
      before the goal. Nor does it there, unless an open interval begins or the window of the bound has not begun.
  *)
  | Everywhere of int Lazy.t
  (** No run decides otherwise. All runs together visit this number of nodes; it is 0 if they do not leave the flow
      of the position. *)
  | Likelihood of {
      side : Timed_formula.side;
      measured : Eval.measured;
      run : (Run.t * Scc_exact.Rat.t) option;
      parts : t list;
    }
  (** The probability of the operator for that side. [run] is a run of a scheduler that attains it, with its own
      probability. The run satisfies F or U, or violates G. [parts] explain its goal. *)

(** The origin of a run. *)
and way =
  | Own  (** found by a search of its own *)
  | Onward of Course.place option
  (** The continuation of the run along which the formula is explained, to this place of its course; [None] if it
      is endless or goes past the bound. *)

(** The claim that a formula holds, or does not ([claimed]), at places on the way of a run, with an explanation at
    each. *)
and along = { claim : Timed_formula.t; claimed : bool; course : Course.t; stretches : stretch list }

and stretch = { place : Course.place; why : t Lazy.t }

exception Not_known
(** A truth that is not known, or was known, and needs more effort now than is left. *)

val explain : Eval.t -> Timed_formula.t -> Positions.position -> t
(** [explain e f p] is why [f] holds at position [p], or why it does not.
    @raise Not_known if that is undecided, also when parts that are lazy are looked at. *)

val goes_on : Run.t -> bool
(** [goes_on run] is true if the run should be appended to a run that leads to its start. It is false if the run
    only stays in the flow in which it begins, to rest there, or to pass a bound at once. Such a run would hide
    the instant at which it begins. *)

val chain : t -> Run.t option
(** [chain t] is one run from the position of the explanation: its run, followed by the run of the first part that
    has one, and so on. It is [None] if no part has a run. *)

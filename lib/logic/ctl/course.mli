(** The course of a run: the nodes, instants and intervals of flows that it passes, such that no part of given
    formulas changes within an interval. *)

open Scc_exact

(** A node, an instant inside a flow, or an open interval of a flow. *)
type place = {
  step : int;  (** the number of steps of the run before it *)
  position : Positions.position;  (** the node or the instant; for an interval a position inside *)
  low : Algebraic.t;  (** the offset at which the interval begins, or that of the node or instant *)
  high : Algebraic.t option;  (** the offset at which it ends; [None] if it lasts for ever *)
  clock : Rat.t;
  (** The time at which the node of the place was entered, counted from when the first node was. The time of the
      position is this plus its offset. *)
}

val is_interval : place -> bool
(** [is_interval p] is true for an open interval, and false for a node or an instant. *)

type t = private {
  run : Run.t;
  places : place array;
  (** In order, before the goal of the run. A goal inside an interval belongs to the last place. *)
  again : int option;  (** for a run that repeats itself: the index of the place from which it repeats *)
  period : Rat.t;  (** the time of each repetition; 0 for a run that does not repeat itself *)
}

val make : Eval.t -> Timed_formula.t list -> Run.t -> t
(** [make e formulas run] is the course of [run]. In each interval all parts of the formulas, at any depth, are
    constant. *)

val within : t -> Timed_formula.bound -> int list
(** [within t bound] is the indices of the places at which the time since the start of the run can be within the
    bound. For a run that repeats itself the high end of the bound is ignored. Places that repeat in positive time
    count as after the low end. *)

(** {1 The rest of a run} *)

(** A position of the run, within the place of this index. *)
type spot = { course : t; index : int; at : Positions.position }

val follow : Eval.t -> Eval.until -> spot -> (Run.t * spot option) option
(** [follow e u spot] is a run that continues from the spot as the run of the course, and decides [u] there. For
    [E] it shows that [u] holds, and for [A] that it does not. With it comes the spot to which it leads. The spot
    is [None] if the run goes on without end, or past the bound. The result is [None] if the continuation does not
    decide [u], or not within a few repetitions, and for probabilities and irrational offsets. *)

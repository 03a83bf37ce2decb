(** What a run goes through, position by position: nodes, and the cells of flows in which nothing changes that a
    formula speaks of. *)

open Scc_exact

(** A node, an instant inside a flow, or an open interval of a flow. *)
type place = {
  step : int;  (** the steps of the run that are made before it *)
  position : Positions.position;  (** the node or the instant; of an interval a position inside *)
  low : Algebraic.t;
  high : Algebraic.t option;
  (** offsets: where the interval begins and ends ([None]: it lasts for ever); both that of the instant *)
  clock : Rat.t;
  (** when the node of the place was entered, from the time on at which the start's node was: that of the
      position is this and its offset *)
}

val is_interval : place -> bool

type t = private {
  run : Run.t;
  places : place array;  (** up to the goal of the run: that itself is not among them, unless in an interval *)
  again : int option;  (** of a run that repeats itself: from this place on *)
  period : Rat.t;  (** how long that takes each time; 0 of a run that does not *)
}

val make : Eval.t -> Formula.t list -> Run.t -> t
(** Nothing changes in an interval that is a part of the formulas, at any depth. *)

val within : t -> Formula.bound -> int list
(** The places, by their indices, at which the time that has passed since the start of the run can be within the
    bound. Of a run that repeats itself nothing is beyond the bound's end, and what comes again and again comes
    after its low end. *)

(** {1 The rest of a run} *)

(** A position of the run: in the place of this index. *)
type spot = { course : t; index : int; at : Positions.position }

val follow : Eval.t -> Eval.until -> spot -> (Run.t * spot option) option
(** A run that shows of the until what its quantifier lets a run show ([E]: that it holds, [A]: that it does not),
    by going on from the spot as the run of the course does, and the spot that it leads to ([None]: it goes on as
    the run does, without end, or past the bound). [None]: the run does not show it there, or it is not easily
    seen. *)

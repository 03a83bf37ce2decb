(** The outcomes of many runs for one question. *)

open Scc_exact
module Values : Map.S with type key = Rat.t

(** Numbers of runs by outcome, and sums of numbers. *)
type t = {
  runs : int;
  yes : int;
  no : int;
  free : int;  (** depend on a choice that is not drawn *)
  bounces : int;  (** those of [free] whose choice is {!Sample.Walkers_bounce} *)
  splits : int;  (** those of [free] whose choice is {!Sample.Splits} *)
  too_long : int;  (** were stopped before the outcome was known *)
  bounds : Sample.bound list;  (** the bounds that stopped them, each once *)
  never : int;
  no_value : int;
  why : string option;  (** the reason of the first run without a value *)
  numbers : int;
  sum : Rat.t;  (** of the numbers *)
  squares : Rat.t;
  values : int Values.t;  (** the numbers of runs, each once, with the number of runs that have it *)
}

val empty : t
(** No runs. *)

val add : t -> Sample.outcome -> t
(** Adds the outcome of a run. *)

val open_ended : t -> int
(** The number of runs that leave the question open. *)

val likelihood : t -> miss:Rat.t -> Rat.t * Rat.t
(** An interval that contains the probability, whatever is chosen where nothing is drawn. It misses the
    probability with at most the probability [miss], less than 1. Open runs count as no at its lower end, and as
    yes at its upper end. *)

val mean : t -> Range.t -> look:Rat.t -> miss:Rat.t -> Rat.t option * Rat.t option
(** Bounds of the mean of numbers that are always in the range: a lower one if the range has a low end, and an
    upper one if it has a high end. Each run has a number or is open. An open run counts as the low end of the
    range for the lower bound, and as the high end for the upper one.

    Let the bounds be computed after each run of a sample that grows without end. Then with at most the probability
    [miss] the mean is ever beyond one of them (law {e Betting}). For a number that is one of two the bounds are
    those of {!likelihood}: these miss the mean with at most the probability [look]. *)

val known_mean : t -> Rat.t option
(** The mean of the numbers, if some runs have one and others are open. It is no estimate of the mean over all
    runs: what the others come to may differ from it in one direction. *)

val spread : t -> (Rat.t * Rat.t option) option
(** The mean of the numbers, if there are any, and their standard deviation, if there are two or more. The
    deviation divides the sum of squares by the number of values less one. It is rounded up by less than 2{^-39}
    of itself. If no range is known, nothing follows from them for the mean over all runs. *)

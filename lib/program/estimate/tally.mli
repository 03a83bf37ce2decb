(** The outcomes of many runs for one question. *)

open Scc_exact

(** Numbers of runs by outcome, and sums of numbers. *)
type t = {
  runs : int;
  yes : int;
  no : int;
  free : int;  (** depend on a choice that is not drawn *)
  bounces : int;  (** those of [free] whose choice is {!Sample.Walkers_bounce} *)
  too_long : int;  (** were stopped before the outcome was known *)
  bounds : Sample.bound list;  (** the bounds that stopped them, each once *)
  never : int;
  no_value : int;
  why : string option;  (** the reason of the first run without a value *)
  numbers : int;
  sum : Rat.t;  (** of the numbers *)
  squares : Rat.t;
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

val mean : t -> Range.t -> miss:Rat.t -> Rat.t * Rat.t
(** An interval that contains the mean of numbers that are always in the range; it misses the mean with at most
    the probability [miss]. Each run has a number or is open. An open run counts as the low end of the range at
    the lower end of the interval, and as the high end at the upper one.

    Inside a range, the tails of sums are at most e times those of the binomial distribution with the same mean.
    This is Theorem 1.2 of Bentkus, On Hoeffding's inequalities, 2004. *)

val spread : t -> (Rat.t * Rat.t option) option
(** The mean of the numbers, if there are any, and their standard deviation, if there are two or more. The
    deviation divides the sum of squares by the number of values less one. It is rounded up by less than 2{^-39}
    of itself. If no range is known, nothing follows from them for the mean over all runs. *)

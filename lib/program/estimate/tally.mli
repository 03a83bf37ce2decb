(** What was found on many runs of one question. *)

open Scc_exact

type t = {
  runs : int;
  yes : int;
  no : int;
  free : int;  (** it depends on a choice that nothing draws *)
  too_long : int;
  never : int;
  no_value : int;
  why : string option;  (** of the first that has no value *)
  numbers : int;
  sum : Rat.t;  (** of the numbers *)
  squares : Rat.t;
}

val empty : t
val add : t -> Sample.outcome -> t

val open_ended : t -> int
(** How many leave the question open. *)

val likelihood : t -> miss:Rat.t -> Rat.t * Rat.t
(** An interval in which the probability is, whatever is chosen where nothing is drawn. That it is not there has at
    most the probability [miss], less than 1: what is open counts for no at its lower end, and for yes at its upper
    one. *)

val mean : t -> Range.t -> miss:Rat.t -> Rat.t * Rat.t
(** Likewise for the mean of numbers that are always in the range, of runs of which each comes to a number or is
    open; an open one counts for the low end of the range at the lower end of the interval, and for the high one at
    the upper end. Between the ends of a range the tails of sums are at most e times those of the binomial
    distribution with the same mean (Bentkus, On Hoeffding's inequalities, 2004, Theorem 1.2). *)

val spread : t -> (Rat.t * Rat.t option) option
(** The mean of the numbers, if there are any; and their standard deviation, if there are two or more: from the
    squares by one less than their number, rounded up by less than 2{^-39} of itself. Nothing follows from them for
    the mean over all runs where no range is known. *)

(** Markov decision processes whose probabilities and rewards are rational functions of one parameter, on an open
    interval on which no probability vanishes: values as functions of the parameter (rule Parametric; Daws,
    "Symbolic and parametric model checking of discrete-time Markov chains", 2004; Baier et al., "Parametric
    Markov chains: PCTL complexity and fraction-free Gaussian elimination", 2020).

    The value of a scheduler is a rational function, since it solves a linear system. The degrees of numerator and
    denominator are bounded by Cramer's rule, component by component. So finitely many exact values decide it: a
    function of lower degree that has so many of these values is the one. It is guessed from a few values
    ({!Scc_exact.Interpolation}), and proved by the others.

    Where schedulers choose, one that is best for one value of the parameter stays so until another choice becomes
    better. The gains of all other choices are functions as well, and the first change of sign of one of them is
    found exactly. *)

open Scc_exact

type t

val make :
  Backwards.t -> probability:(int -> Rational_function.t) -> reward:(int -> Rational_function.t) ->
  low:Rat.t -> high:Rat.t -> t
(** [make b ~probability ~reward ~low ~high] is the MDP of [b] with these probabilities of branches and rewards of
    choices, for all values of the parameter in the open interval from [low] to [high]. There probabilities are
    positive and have the sum 1 for each choice. A reward is 0 everywhere or nowhere. *)

type value = Finite of Rational_function.t | Infinite

(** A value on the open interval from [low] to [high]. *)
type piece = { low : Algebraic.t; high : Algebraic.t; value : value }

type given_up =
  | Solver of Exact_solver.given_up  (** one exact value takes too much *)
  | Too_many of int  (** so many exact values would be needed *)
  | Interrupted

(** What was found before that: pieces on parts of the interval, by their places, and values at single points. *)
type found = { pieces : piece list; values : (Rat.t * Rat.t) list }

type stopped = { why : given_up; found : found }

val solve : t -> Solution.problem -> Effort.t -> asked:int -> (piece list, stopped) result
(** [solve p problem effort ~asked] is the value of state [asked]: pieces that join each other, with different
    functions, from the low end of the interval to its high end. Where two pieces meet both functions have the same
    value. *)

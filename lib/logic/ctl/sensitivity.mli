(** Probabilities and means as functions of a parameter that the probabilities of edges depend on (rule
    Parametric). *)

open Scc_exact
open Scc_chance

(** The parameter: its open range, and the probabilities as functions of it. *)
type parameter = {
  low : Rat.t;
  high : Rat.t;
  drawn : int -> Rational_function.t option array option;
  (** as {!Timed_graph.t.drawn}, whose numbers are the values of these functions at one point of the range *)
}

(** The reason why a function is not known. *)
type reason = Interrupted | Unknown of string

type failure = { reason : reason; found : Parametric.found  (** what was found of the value all the same *) }
type 'a result = ('a, failure) Stdlib.result

val probability : Eval.t -> parameter -> Timed_formula.side -> Timed_formula.t -> Parametric.piece list result
(** [probability e k side f] is the least or greatest probability that a run from node 0 satisfies the top
    operator of [f], whatever its quantifier. The operator is F, G or U (a bug otherwise). *)

val mean : Eval.t -> parameter -> Timed_formula.side -> Expectation.what -> Parametric.piece list result
(** [mean e k side what] is the least or greatest mean over runs from node 0. *)

val where :
  Eval.t -> parameter -> probability:(Timed_formula.side -> Timed_formula.t -> Parametric.piece list result) ->
  Timed_formula.t -> Dependence.set result
(** [where e k ~probability f] is the values of the parameter for which [f] holds at node 0. Tests of
    probabilities may be combined by "not", "and" and "or"; within other operators they are a reason for an error.
    [probability] is {!val-probability} of [e] and [k], or what was kept of it. *)

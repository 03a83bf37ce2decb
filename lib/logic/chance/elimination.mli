(** Sparse linear systems x = b + P x over the rationals, solved by elimination. P is a matrix of probabilities:
    its rows have sums of at most 1, and from each unknown a path leads to a row with a sum below 1.

    Unknowns are eliminated one by one, as states of a Markov chain (Daws, "Symbolic and Parametric Model Checking
    of Discrete-Time Markov Chains", 2004). The next one has the least product of the number of unknowns that
    depend on it and the number of unknowns that it depends on (Markowitz). Pivots are on the diagonal. They are
    positive: 1 minus the coefficient of an unknown in its own row is at least the probability that the unknown is
    left for ever. Once each elimination makes more entries than it removes, [Lifting] solves what is left. *)

open Scc_exact

type given_up =
  | Interrupted
  | Too_long  (** a number has more bits than allowed *)

val solve :
  size:int ->
  row:(int -> (int * Rat.t) list) ->
  constant:(int -> Rat.t) ->
  bits:int ->
  interrupted:(unit -> bool) ->
  (Rat.t array, given_up) result
(** [solve ~size ~row ~constant ~bits ~interrupted] is the solution x. [row i] is row [i] of P as pairs of a column
    and its entry, each column at most once; [constant i] is b(i). [bits] limits the length of each number
    ({!Scc_exact.Rat.bits}). [interrupted] is called before each elimination. *)

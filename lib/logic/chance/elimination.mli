(** Sparse linear systems x = b + P x over the rationals, where P is a matrix of probabilities (its rows have sums
    at most 1) and from each unknown a way leads to a row with a sum below 1. Unknown by unknown is eliminated, as
    are states of a Markov chain (Daws, "Symbolic and Parametric Model Checking of Discrete-Time Markov Chains",
    2004): next the one that has the least product of unknowns that ask for it and unknowns that it asks for
    (Markowitz). The pivots are on the diagonal, and never 0, since 1 minus what leads back to an unknown is the
    probability, or more, that it is left for ever. *)

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
(** Row [i] of P as pairs of a column and what is there, each column once at most; and [b]. *)

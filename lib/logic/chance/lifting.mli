(** Sparse linear systems A x = b over the rationals, solved modulo a prime p and lifted to powers of p (Dixon,
    "Exact solution of linear equations using p-adic expansions", 1982).

    A is factored once, modulo p, in an order with few new entries ({!Fill_order}, {!Factors}). Each digit of x to
    the base p is then one solution modulo p. From enough digits follow fractions over one denominator. These are
    proved by putting them into the rows. So no result depends on the choice of p, or on how long the numbers are
    expected to be. The leading minors of A are not 0, as those of I - P for probabilities P. *)

open Scc_exact

type given_up =
  | Interrupted
  | Too_long  (** a number of the solution has more bits than allowed, as far as its digits tell *)
  | Too_much  (** it takes more steps than allowed *)

(** Numbers over one positive denominator, and the steps that were taken. *)
type solution = { numerators : Z.t array; denominator : Z.t; steps : int }

val solve :
  size:int ->
  row:(int -> (int * Rat.t) list) ->
  constant:(int -> Rat.t) ->
  bits:int ->
  steps:int ->
  interrupted:(unit -> bool) ->
  (solution, given_up) result
(** [solve ~size ~row ~constant ~bits ~steps ~interrupted] is the solution. [row i] is row [i] of A as pairs of a
    column and its entry, each column at most once; [constant i] is b(i). [bits] limits the length of each number
    ({!Scc_exact.Rat.bits}), and [steps] the work: products of two numbers of 28 bits, of which a machine makes
    some hundred millions a second. [interrupted] is called while it goes on. *)

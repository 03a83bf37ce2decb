(** Linear systems A x = b over the rationals, solved modulo a prime p and lifted to powers of p (Dixon, "Exact
    solution of linear equations using p-adic expansions", 1982).

    A is factored once, modulo p. Each digit of x to the base p is then one solution modulo p, and what is left
    of b stays short. From enough digits follow fractions over one denominator. These are proved by putting them
    into the rows. So no result depends on the choice of p, or on how long the numbers are expected to be. *)

open Scc_exact

type given_up =
  | Interrupted
  | Too_long  (** a number of the solution has more bits than allowed, as far as its digits tell *)
  | Unfit  (** the rows have integers that are too long, or the matrix has no inverse modulo any of the primes *)

val solve :
  size:int ->
  row:(int -> (int * Rat.t) list) ->
  constant:(int -> Rat.t) ->
  bits:int ->
  interrupted:(unit -> bool) ->
  (Rat.t array, given_up) result
(** [solve ~size ~row ~constant ~bits ~interrupted] is the solution. [row i] is row [i] of A as pairs of a column
    and its entry, each column at most once; [constant i] is b(i). [bits] limits the length of each number
    ({!Scc_exact.Rat.bits}). It takes size{^3} / 3 steps for the factors, and 2 size{^2} for each digit.
    [interrupted] is called while it goes on. *)

(** Arrays of floats that are proved to be below and above the solution of equations, and the sweeps that bring
    them nearer to it. OCaml has no modes of rounding: each right side of a row is worked out with the ordinary
    operations, and moved by a bound of all errors.

    {1 The bound}

    Let u = 2^-53, S = c + sum p(i) x(i) over k entries, where the x(i) are floats from 0 to {!ceiling}, and Z what
    is computed for it. All terms are at least 0, so nothing cancels. Each operation has a relative error of u at
    most, and so has the float that stands for p(i); a term goes through k additions, one product, and the rounding
    of p(i): S (1 - u)^(k + 2) - n <= Z <= S (1 + u)^(k + 2) + n, where n is what is lost when numbers are too
    small for that. This is at most 2^-1074 for each product, and 2^-1074 x(i) for each p(i), together less than k
    10^-305: below 10^-280, as k < 2^48. With [tiny] = 10^-250 and [step] = 2^-52 = 2 u:

    - Below. When Z < tiny, 0 will do. Else n < u Z, and S >= Z (1 - u) / (1 + u)^(k + 2). The product of Z and
      1 - (k + 6) step is rounded once more; 1 - (k + 6) step <= 1 - (k + 4) u <= (1 - u) / (1 + u)^(k + 3).
    - Above. Z + tiny is rounded once, and more than n is added; then the product of that and 1 + (k + 6) step.
      S <= (Z + tiny) / (1 - u)^(k + 2), and 1 + (k + 6) step >= 1 / (1 - u)^(k + 4), as (k + 4) u < 1/2.

    Both factors are floats, as k < 2^48. The constant of a row is the float below its nearest one, or above. *)

open Scc_exact

type t = private {
  equations : Equations.t;
  is_max : bool;  (** whether the best row is the greatest *)
  below : float array;  (** the constants of rows *)
  above : float array;
  lower : float array;  (** of each node: at most its value *)
  upper : float array;  (** at least its value; may be infinite *)
  low_row : int array;
  (** Of each node one of its rows: the values of that scheduler are at least [lower] when the greatest values are
      asked for. [lower v] is never more than the right side of the row for [lower], as it has been proved when the
      row was put there, and [lower] has only grown since then. *)
  high_row : int array;
  (** The values of that scheduler are at most [upper], when the least values are asked for: in the same way. *)
  guess : float array;  (** where the values seem to be *)
  row : int array;  (** of each node, the row that seemed to be the best *)
  before : float array;  (** what was remembered of [guess] *)
  measure : float array;
  (** One number: of the last sweep of [guess], the sum of all changes; of that of a trial, how many nodes spoke
      against it. *)
  low_trial : float array;
  (** Of the nodes in the component that is worked on: what may be below; of all others as [lower]. *)
  high_trial : float array;  (** In the same way: what may be above; of all others as [upper]. *)
  trial_row : int array;
  sums : float array;  (** the right sides of the rows of some nodes that are looked at together *)
}

val ceiling : float
(** 10^18: no number in [lower] is greater, nor is a finite one in [upper]. *)

val start : Equations.t -> upper:float -> t
(** With 0 and a number that is at least all values. *)

(** {1 Guessing}

    Nothing is proved here, and nothing is lost if a guess is wrong. *)

val improve : t -> first:int -> last:int -> forward:bool -> relative:bool -> float
(** One sweep over the nodes from first to last: in [guess] each becomes the right side, for what the others are
    then, and in [row] the best of its rows. The greatest change, or the greatest share of a change in what came
    out. *)

val evaluate : t -> first:int -> last:int -> forward:bool -> relative:bool -> stride:float -> float
(** The same of the rows in [row] alone: this is much quicker, as it does not wait for the comparison of rows. Each
    change is made [stride] times as great (successive over-relaxation). *)

val begin_high : t -> first:int -> last:int -> unit
(** [guess] becomes what is above; {!begin_low}: what is below. *)

val begin_low : t -> first:int -> last:int -> unit
val remember : t -> first:int -> last:int -> unit
val go_on : t -> first:int -> last:int -> factor:float -> unit
(** The change since {!remember} once more, so many times. *)

val steps : t -> t
(** For guesses alone: of the same rows, the greatest expected number of steps before nodes are left whose number
    is 0, which all are in the beginning. *)

val settle : t -> first:int -> last:int -> unit
(** [guess] becomes the middles of intervals, or what is below where nothing is known above. *)

(** {1 Proving} *)

val set_low : t -> int -> float -> unit
val set_high : t -> int -> float -> unit
(** Puts a number to be tried; what is already known is not tried to be worse, and nothing finite above {!ceiling}.
*)

type trial =
  | Proved  (** the trial has become numbers that are below, or above *)
  | Open
  | Refuted  (** some number has come below [lower]: it is not above *)

val sweep_low : t -> first:int -> last:int -> forward:bool -> trial
(** Each node of the trial becomes its right side, or what [lower] says, if that is more. When none has fallen
    by that, each was found with numbers that were not greater than those that are there in the end; so with the
    trial l, the solution x, and [lower] <= x, it is l <= max(right sides of l, [lower]). Then m = max(l, x) is
    at most its own right sides: where l > x those of l were taken, and elsewhere x is its own right side. So
    for some scheduler m is at most its right sides: for the greatest values, that of the best rows for m; for
    the least, any, and so the best one. That one leaves the component (for the greatest values all do), so its
    values are the limit of its right sides from any numbers, and as these only grow from m on, m is at most its
    values, and these are no better than x. Hence l <= x. Never [Refuted]. *)

val sweep_high : t -> first:int -> last:int -> forward:bool -> trial
(** In the same way, each becomes its right side, or what [upper] says, if that is less. When none has grown,
    the trial h is at least min(right sides of h, [upper]). The solution is the limit of right sides from 0 on,
    all of which are at most [upper]: by induction each is at most h (Park's induction; Hartmanns and Kaminski,
    "Optimistic Value Iteration", 2020). In the same way h is at least the values of the rows that are told, for
    the least values: of [trial_row], or of [high_row] where [upper] was taken. That holds if those rows leave
    the component, which a scheduler that pays no more than h does. *)

val accept_low : t -> first:int -> last:int -> unit
(** After [Proved]: [lower] becomes what is greater. *)

val accept_high : t -> first:int -> last:int -> unit
(** After [Proved]: [upper] becomes what is less. *)

val drop_low : t -> first:int -> last:int -> unit
val drop_high : t -> first:int -> last:int -> unit

val single : t -> int -> unit
(** Both sides of a node that is a component by itself. *)

val interval : t -> int -> Rat.t * Rat.t option
(** Of a node; [None]: nothing is known above. *)

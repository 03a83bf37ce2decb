(** Arrays of floats that are proved to be below and above the solution of equations, and the sweeps that bring
    them nearer to it. OCaml has no modes of rounding. So each right side of a row is computed with the ordinary
    operations, and then moved by a bound of all errors.

    {1 The bound}

    Let u = 2^-53 and S = c + sum p(i) x(i) over k entries, where the x(i) are floats from 0 to {!ceiling}. Let Z
    be the computed float. All terms are at least 0, so nothing cancels. Each operation has a relative error of at
    most u, and so has the float nearest to p(i). A term goes through k additions, one product, and the rounding of
    p(i).

    So S (1 - u)^(k + 2) - n <= Z <= S (1 + u)^(k + 2) + n, where n bounds the loss by underflow. It is at most
    2^-1074 for each product, and 2^-1074 x(i) for each p(i). Together that is less than k 10^-305: below 10^-280,
    as k < 2^48. With [tiny] = 10^-250 and [step] = 2^-52 = 2 u:

    - Below. When Z < tiny, 0 will do. Else n < u Z, and S >= Z (1 - u) / (1 + u)^(k + 2). The product of Z and
      1 - (k + 6) step is rounded once more; 1 - (k + 6) step <= 1 - (k + 4) u <= (1 - u) / (1 + u)^(k + 3).
    - Above. Z + tiny is rounded once, and more than n is added; then the product of that and 1 + (k + 6) step.
      S <= (Z + tiny) / (1 - u)^(k + 2), and 1 + (k + 6) step >= 1 / (1 - u)^(k + 4), as (k + 4) u < 1/2.

    Both factors are floats, as k < 2^48. The constant of a row is the float below its nearest one, or above. *)

open Scc_exact

type t = private {
  equations : Equations.t;
  is_max : bool;  (** the best row of a node is the one with the greatest right side *)
  below : float array;  (** for each row: at most its constant *)
  above : float array;  (** for each row: at least its constant *)
  lower : float array;  (** for each node: at most its value *)
  upper : float array;  (** for each node: at least its value; may be infinite *)
  low_row : int array;
  (** For each node one of its rows. For greatest values, the values of this scheduler are at least [lower]: [lower
      v] is at most the right side of the row for [lower]. That was proved when the row was stored, and [lower] has
      only grown since then. *)
  high_row : int array;
  (** For each node one of its rows. For least values, the values of this scheduler are at most [upper]. *)
  guess : float array;  (** for each node: a guess of its value *)
  row : int array;  (** for each node: the best row for [guess] *)
  before : float array;  (** the copy of [guess] by {!remember} *)
  measure : float array;
  (** One number about the last sweep: the sum of all changes of [guess], or the number of nodes that contradict a
      trial. *)
  low_trial : float array;
  (** For the nodes of the present component: candidates for [lower]. For all others it is [lower]. *)
  high_trial : float array;
  (** For the nodes of the present component: candidates for [upper]. For all others it is [upper]. *)
  trial_row : int array;  (** for each node: its best row in the last sweep of a trial *)
  sums : float array;  (** the right sides of the rows of a block of nodes *)
}

val ceiling : float
(** 10^18: no number in [lower] is greater, nor is a finite one in [upper]. *)

val start : Equations.t -> upper:float -> t
(** [start e ~upper] has 0 in [lower] and [upper] in [upper], which is at least all values and may be infinite. *)

(** {1 Guessing}

    Guesses prove nothing, and a wrong guess costs only time. Each function works on the nodes from [first] to
    [last]. *)

val improve : t -> first:int -> last:int -> forward:bool -> relative:bool -> float
(** [improve t ~first ~last ~forward ~relative] is one sweep, upwards if [forward]. The guess of each node becomes
    its best right side for the present guesses, and [row] its best row. It returns the greatest change: absolute,
    or as a share of the new guess if [relative]. *)

val evaluate : t -> first:int -> last:int -> forward:bool -> relative:bool -> stride:float -> float
(** [evaluate t ~first ~last ~forward ~relative ~stride] is as {!improve}, but for the rows in [row] only. That is
    much quicker, as no rows are compared. Each change is multiplied by [stride] (successive over-relaxation). *)

val begin_high : t -> first:int -> last:int -> unit
(** [begin_high t ~first ~last] copies [upper] to [guess]. *)

val begin_low : t -> first:int -> last:int -> unit
(** [begin_low t ~first ~last] copies [lower] to [guess]. *)

val remember : t -> first:int -> last:int -> unit
(** [remember t ~first ~last] copies [guess] to [before]. *)

val go_on : t -> first:int -> last:int -> factor:float -> unit
(** [go_on t ~first ~last ~factor] adds [factor] times the change since {!remember} to each guess. The sums are
    clamped to 0 and [upper]. *)

val steps : t -> t
(** [steps t] is for guesses only: the same rows with the constant 1, all guesses 0, and the greatest row as the
    best. In a component, its guesses tend to the greatest expected number of steps before the component is left.
*)

val settle : t -> first:int -> last:int -> unit
(** [settle t ~first ~last] puts the middle of each interval into [guess], or [lower] if [upper] is infinite. *)

(** {1 Proving} *)

val set_low : t -> int -> float -> unit
(** [set_low t v x] makes [x] the lower trial of node [v], at least [lower] and at most {!ceiling}. *)

val set_high : t -> int -> float -> unit
(** [set_high t v x] makes [x] the upper trial of node [v], at most [upper]; a number above {!ceiling} becomes
    infinite. *)

type trial =
  | Proved  (** all numbers of the trial are below the solution, or above it *)
  | Open  (** another sweep may prove the trial *)
  | Refuted  (** some number of an upper trial has come below [lower]: it cannot be above the solution *)

val sweep_low : t -> first:int -> last:int -> forward:bool -> trial
(** [sweep_low t ~first ~last ~forward] is one sweep of the lower trial: each node becomes its best right side,
    rounded down, or [lower] if that is more. It is [Proved] if no node has fallen, and [Open] otherwise.

    Proof. If no node has fallen, each was computed from numbers that are at most the final ones. Let l be the
    trial, x the solution, and [lower] <= x. Then l <= max(right sides of l, [lower]). So m = max(l, x) is at most
    its own right sides: where l > x those of l were taken, and elsewhere x is its own right side.

    So m is at most its right sides for some scheduler: for greatest values that of the best rows for m, and for
    least values any, so also the best one. This scheduler leaves the component (for greatest values all do). Hence
    its values are the limit of its right sides from any numbers. These only grow from m on, so m is at most its
    values, which are no better than x. Hence l <= x. *)

val sweep_high : t -> first:int -> last:int -> forward:bool -> trial
(** [sweep_high t ~first ~last ~forward] is one sweep of the upper trial: each node becomes its best right side,
    rounded up, or [upper] if that is less. It is [Refuted] if a node has come below [lower]. It is [Proved] if no
    node has grown and all are finite, and [Open] otherwise.

    Proof. If no node has grown, the trial h is at least min(right sides of h, [upper]). The solution is the limit
    of right sides from 0 on, all of which are at most [upper]. By induction each is at most h (Park's induction;
    Hartmanns and Kaminski, "Optimistic Value Iteration", 2020).

    For least values, h is likewise at least the values of a scheduler: of [trial_row], or of [high_row] where
    [upper] was taken. That holds if those rows leave the component, which a scheduler that pays no more than h
    does. *)

val accept_low : t -> first:int -> last:int -> unit
(** [accept_low t ~first ~last], after [Proved], raises [lower] to the trial where that is greater, with its rows.
*)

val accept_high : t -> first:int -> last:int -> unit
(** [accept_high t ~first ~last], after [Proved], lowers [upper] to the trial where that is less, with its rows. *)

val drop_low : t -> first:int -> last:int -> unit
(** [drop_low t ~first ~last] resets the lower trial to [lower]. *)

val drop_high : t -> first:int -> last:int -> unit
(** [drop_high t ~first ~last] resets the upper trial to [upper]. *)

val single : t -> int -> unit
(** [single t v] computes both bounds and the guess of a node [v] that is a component by itself. *)

val interval : t -> int -> Rat.t * Rat.t option
(** [interval t v] is the exact rational values of [lower] and [upper] of node [v]; [None] if [upper] is infinite.
*)

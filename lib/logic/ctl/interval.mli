(** The operators with a bound [a, b], a > 0: f at all positions with elapsed time below a, and phi = "f U[0, b -
    a] g" at the first position at which a has elapsed. For each node, the truth depends on the time that is left
    to a (the rest r). It is piecewise constant in r, and these functions X solve

    - X(s, 0) = phi(s);
    - X(s, r) = f(s) and Q over the ways from s, for r > 0. An edge to t gives X(t, r). A flow of time d gives
      "f on (0, r) and phi at s after r" for r < d, and "f on (0, d) and X(t, r - d)" from d on.

    Q is "some", or "all, and there is one". X is the least solution. The rest decreases along any cycle that takes
    time. So runs on which it does not reach 0 end, or repeat within one instant: they have no position at which a
    has elapsed (rule Run). *)

open Scc_exact

type quantifier = Every_run | Some_run

type solution

val solve :
  Timed_graph.index ->
  quantifier ->
  generous:bool ->
  from:Rat.t ->
  f:Positions.t ->
  phi:Positions.t ->
  solution
(** [solve index q ~generous ~from ~f ~phi] is the functions X for a = [from], by fixed-point iteration from false.
    [generous] is as in {!Until}. *)

val at : solution -> int -> Algebraic.t -> bool
(** [at x s r] is X(s, r), for a rest [r] in [0, a]. *)

val set : solution -> Positions.t
(** [set x] is the positions, nodes and inside flows, at which X holds for the whole rest a: those of the operator.
*)

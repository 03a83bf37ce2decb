(** The operators with a bound [a, b], a > 0: f at all positions with elapsed time below a, and phi = "f U[0, b
    - a] g" at the first position at which a has elapsed. For each node, what is left to a (the rest r) decides:
      truth is piecewise constant in r, and these functions solve

    - X(s, 0) = phi(s);
    - X(s, r) = f(s) and Q over the ways from s, for r > 0: an edge to t gives X(t, r), a flow of time d gives
      "f on (0, r) and phi at s after r" for r < d, and "f on (0, d) and X(t, r - d)" from d on.

    Q is "some", or "all, and there is one". Theirs is the least solution: the rest gets less along any cycle that
    takes time, so that runs on which it does not reach 0 end, or go round within one instant, and those have no
    position at which a has elapsed (rule Run). *)

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

val at : solution -> int -> Algebraic.t -> bool
(** X of a node and a rest in [0, a]. *)

val set : solution -> Positions.t
(** Where X holds of the whole rest a, at nodes and inside flows. *)

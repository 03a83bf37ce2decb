(** {!Equations} solved in rationals, component by component: each after the components that it leads to.

    A component of one node is computed directly. In any other, a scheduler is improved until none is better
    (Howard's policy iteration), and {!Lifting} finds its values. The first scheduler leaves the component from
    every node with probability 1, and so does each better one. It is guessed by value iteration in floats. So one
    system is solved as a rule, and one test shows that no scheduler is better. *)

open Scc_exact

type solution = {
  value : Rat.t array;  (** for each node *)
  row : int array;  (** for each node one of its rows: the scheduler of these rows attains all values *)
}

(** Why there is no solution. *)
type given_up = Lifting.given_up = Interrupted | Too_long | Too_much

val solve : Equations.t -> Effort.t -> (solution, given_up) result
(** [solve e effort] is the solution, within the limits [bits] and [steps] of [effort], or the reason why it was
    given up. Its engine, width and bound do not matter. *)

val evaluate : Equations.t -> Effort.t -> row:int array -> (Rat.t array, given_up) result
(** [evaluate e effort ~row] is the value of each node for the scheduler of these rows, by which all components are
    left with probability 1. *)

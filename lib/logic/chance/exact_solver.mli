(** {!Equations} solved in rationals, component by component: each after the components that it leads to.

    A component of one node is computed directly. In any other, a scheduler is improved until none is better
    (Howard's policy iteration), and [Elimination] finds its values. The first scheduler leaves the component from
    every node with probability 1, and so does each better one. It is guessed by value iteration in floats. So one
    system is solved as a rule, and one test shows that no scheduler is better. *)

open Scc_exact

type solution = {
  value : Rat.t array;  (** for each node *)
  row : int array;  (** for each node one of its rows: the scheduler of these rows attains all values *)
}

(** Why there is no solution. *)
type given_up =
  | Component of int  (** a component of so many nodes, which is more than allowed *)
  | Elimination of Elimination.given_up

val greatest_component : Equations.t -> int
(** [greatest_component e] is the number of nodes of the greatest component; 0 without nodes. *)

val solve : Equations.t -> Effort.t -> (solution, given_up) result
(** [solve e effort] is the solution, within the limits [component] and [bits] of [effort], or the reason why it
    was given up. Its engine, width and bound do not matter. *)

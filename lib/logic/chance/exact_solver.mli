(** The equations, solved in rationals: component by component, from those that lead nowhere else on. A component
    of one node is worked out from what is known; of others, a scheduler is improved until none is better (Howard's
    policy iteration), its values being found by {!Elimination}. The first scheduler leaves the component from
    everywhere with probability 1, and so does each that is better. It is guessed by iteration in floats, so that
    as a rule one system is solved, and another question asked of its solution. *)

open Scc_exact

type solution = {
  value : Rat.t array;  (** of each node *)
  row : int array;  (** of each node, one of those that attain it; all of them together do *)
}

(** Why there is none. *)
type given_up =
  | Component of int  (** of so many nodes: more than allowed *)
  | Elimination of Elimination.given_up

val greatest_component : Equations.t -> int
(** Its nodes. *)

val solve : Equations.t -> Effort.t -> (solution, given_up) result
(** The engine does not matter, nor do width and bound. *)

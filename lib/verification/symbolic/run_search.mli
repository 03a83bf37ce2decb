(** Runs over zones as {!Branching} has found them to exist: forwards, from states from which there is one. *)

open Scc_exact
open Scc_polyhedra

(** Runs that take the same steps: to a node, or to an instant in one of its stretches. *)
type walk = {
  way : Concrete.way;
  node : int;
  inside : (int * Linear.t) option;  (** which of its stretches, and the time since the node *)
}

(** Where a run leads; steps are counted from 0, those that take no time for a weak split as well. *)
type finish =
  | There  (** to where the walk is *)
  | Rests  (** nothing happens any more, and time passes for ever *)
  | Passes  (** what comes next comes after the bound of time *)
  | Repeats of int  (** the steps from this one on bring it back to where it was, but for where the whole is *)
  | Goes_on of int
  (** it is in a state of the zone that it was in before this step, and some run goes on from there; none was found
      that comes back to a state *)

val dimension : walk -> int
(** Of what its forms are over. *)

val steps : walk -> int
(** How many have been taken. *)

val among : State_sets.sets -> walk -> walk list
(** The parts of it that are in a set of states. *)

val right_after : State_sets.model -> State_sets.sets -> walk -> walk list
(** Within the stretch that comes next, where all states from there on are in a set of states. *)

val some_run :
  State_sets.model -> Branching.search -> win:State_sets.sets -> high:Rat.t option -> walk ->
  (walk * finish) option
(** A run that a search is for, which goes on from a walk; [win]: the states from which there is one. One that
    is to go on for ever need not be followed beyond the time [high]. Breadth-first; one in which time goes on
    is preferred. [None]: none was found among the first few thousand. *)

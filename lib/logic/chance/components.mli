(** Strongly connected components and maximal end components of parts of an MDP (de Alfaro 1997; Baier and Katoen,
    algorithm 47). *)

open Scc_data

(** Maximal end components: sets of states with some of their choices. These choices stay in the set, and connect
    each of its states to each other one. *)
type ends = {
  count : int;
  number : int array;  (** the component of each state, from 0 on; -1 for a state in none *)
  internal : Bits.t;
  (** The choices that belong to a component: exactly the allowed ones that stay in the component of their state.
  *)
}

val ends : Backwards.t -> inside:(int -> bool) -> allowed:(int -> bool) -> ends
(** [ends b ~inside ~allowed] is the maximal end components of the states that pass [inside], with those of their
    choices that pass [allowed]. Strong components are computed repeatedly, each time of the parts that have
    changed. *)

val none : Mdp.t -> ends
(** [none m] has no component. *)

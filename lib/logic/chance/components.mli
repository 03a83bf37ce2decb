(** Strongly connected components and maximal end components of parts of an MDP (de Alfaro 1997; Baier and Katoen,
    algorithm 47). *)

open Scc_data

val strong : Mdp.t -> inside:(int -> bool) -> Strong_components.t
(** Of the graph of all branches between states that are inside. *)

(** Maximal end components: sets of states with choices of theirs such that no choice of these leaves the set, and
    by them each state of it can be reached from each. *)
type ends = {
  count : int;
  number : int array;  (** of each state: its component, from 0 on, or -1 when it is in none *)
  internal : Bits.t;  (** the choices that belong to a component: exactly those which stay in that of their state
                      *)
}

val ends : Backwards.t -> inside:(int -> bool) -> allowed:(int -> bool) -> ends
(** Of the part that has the states inside, and of their choices those that are allowed. Strong components are
    taken again and again, each time of what has changed. *)

val none : Mdp.t -> ends
(** No component at all. *)

(** The decision process of "f until g" within a window of time on a timed graph ({!Likelihood}): what can be
    chosen at each of its places, and what comes of it. *)

open Scc_data
open Scc_exact
open Scc_chance

type question = {
  graph : Timed_graph.t;
  side : Formula.side;
  bound : Formula.bound;
  f : Positions.t;
  g : Positions.t;
  generous : bool;  (** as in {!Likelihood.question} *)
}

(** {1 Places} *)

(** Of the time since the node was entered that a run begins in, or in whose flow. *)
type window = { low : Algebraic.t; high : Algebraic.t option }

(** A node, and that time; [None] where the window is open for ever. *)
type place = { node : int; elapsed : Rat.t option }

module Places : Hashtbl.S with type key = place

type next = Goal | Fail | Go of place

(** How a place is left, or where in its flow g is met. *)
type way = Move of Timed_graph.move | During of Timeline.moment | Nowhere

type branch = { way : way; next : next; probability : Rat.t; reward : Rat.t  (** of this branch, at least 0 *) }

val one : ?reward:Rat.t -> way -> next -> branch list
(** A choice that leads to one place. *)

val window : question -> window
val is_open : window -> bool

val is_unbounded : question -> bool
(** No time is out of the window. *)

val limit : Timed_graph.flow -> Algebraic.t option
(** How long it lasts, if not for ever. *)

val place : window -> int -> Rat.t -> place
(** A node after a time. *)

val next : question -> window -> place -> next
(** What it is to be there: g is met, or f is not so, or neither. *)

val choices : question -> window -> place -> branch list list
(** Of a place where neither is so; not empty. Nothing is earned by them. *)

val from : question -> Positions.position -> window * branch list list
(** What can come next at a position, with the window as it is seen from the node of its flow. *)

(** {1 With numbers for its states} *)

type built = {
  mdp : Mdp.t;
  numbers : int Places.t;
  places : place Growable.t;
  asked : int list;  (** the states of what it was built from, in that order *)
}

val build : choices:(place -> branch list list) -> next list -> built
(** All that can be reached. *)

val number : built -> next -> int
val until : built -> Qualitative.t
(** To meet the goal. *)

val direction : Formula.side -> Equations.direction

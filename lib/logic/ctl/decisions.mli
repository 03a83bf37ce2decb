(** The Markov decision process of "f until g" within a window of time on a timed graph ({!Likelihood}): the
    places, the choices at each, and the results of each choice. *)

open Scc_data
open Scc_exact
open Scc_chance

type question = {
  graph : Timed_graph.t;
  side : Timed_formula.side;
  bound : Timed_formula.bound;
  f : Positions.t;
  g : Positions.t;
  generous : bool;  (** as in {!Likelihood.question} *)
}

(** {1 Places} *)

(** The window of time in which g counts. It is counted from when the first node of the run was entered, also for a
    run that begins in the flow of that node. [high] is [None] without an end. *)
type window = { low : Algebraic.t; high : Algebraic.t option }

(** A node, and the time at which it is entered. The time is [None] once the window has begun and has no end: then
    it does not matter. *)
type place = { node : int; elapsed : Rat.t option }

module Places : Hashtbl.S with type key = place

(** The state after a branch: the run has met g, or can no longer, or goes on from a place. *)
type next = Goal | Fail | Go of place

(** How a place is left: by a move, or at the moment in its flow at which g is met, or not at all. *)
type way = Move of Timed_graph.move | During of Timeline.moment | Nowhere

type branch = { way : way; next : next; probability : Rat.t; reward : Rat.t  (** at least 0 *) }

val one : ?reward:Rat.t -> way -> next -> branch list
(** [one ~reward way next] is a choice with one branch, of probability 1; [reward] is 0 by default. *)

val window : question -> window
(** [window q] is the window of a run that begins at a node: the bound of [q]. *)

val is_unbounded : question -> bool
(** [is_unbounded q] is true if every time is in the window. *)

val is_open : window -> bool
(** [is_open w] is true if the window has no end. *)

val reaches_beyond : window -> Algebraic.t -> bool
(** [reaches_beyond w time] is true if the window ends before this time. *)

val limit : Timed_graph.flow -> Algebraic.t option
(** [limit flow] is how long the flow lasts; [None] for no flow, and for one that lasts for ever. *)

val place : window -> int -> Rat.t -> place
(** [place w node time] is the node, entered at this time. *)

val next : question -> window -> place -> next
(** [next q w p] is [Goal] if g is met at [p], [Fail] if f does not hold or the window is over, and [Go p]
    otherwise. A node that is not known is [Goal] if [q] is generous, and [Fail] if not. *)

val choices : question -> window -> place -> branch list list
(** [choices q w p] is the choices at a place [p] with [next q w p = Go p]. There is at least one; rewards are 0.
*)

val meetings : question -> window -> place -> Timeline.moment list
(** [meetings q w p] is how long after it is entered a place [p] with [next q w p = Go p] leads to [Goal]: a moment
    for each such branch. *)

val from : question -> Positions.position -> window * branch list list
(** [from q p] is the choices at a position, and the window counted from when the node of its flow was entered. *)

(** {1 As an MDP} *)

type built = {
  mdp : Mdp.t;  (** state 0 is [Goal], state 1 is [Fail], and the others are places *)
  numbers : int Places.t;  (** the state of each place *)
  places : place Growable.t;  (** the place of each state from 2 on *)
  asked : int list;  (** the states of the starts, in their order *)
}

val build : choices:(place -> branch list list) -> next list -> built
(** [build ~choices starts] is the MDP of all places that can be reached from the starts. *)

val number : built -> next -> int
(** [number b next] is the state of [next]. A place must be one that was reached ([Not_found] otherwise). *)

val until : built -> Qualitative.t
(** [until b] is the formula that the run meets [Goal]. *)

val same_process : built -> built -> bool
(** [same_process a b] is true if both have the same states with the same choices, and the same starts. *)

val direction : Timed_formula.side -> Equations.direction
(** [direction side] is [Min] for [Least], and [Max] for [Greatest]. *)

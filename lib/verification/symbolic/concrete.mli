(** One run of many along the nodes of a graph to a place: values of the parameters, and instants of splits. *)

open Scc_exact
open Scc_semantics
open Scc_state_sets

type step =
  | Happens of Transition.label
  (** with the names of leaves at the start; a process is given by one of its leaves *)
  | Passes of Rat.t  (** until what comes next *)
  | Passes_some of Rat.t  (** less than that, to a weak split; more than 0 *)

type t = {
  values : Rat.t array;  (** of the parameters *)
  steps : step list;
  offset : Rat.t;  (** the time that passes after the steps *)
}

(** {1 Ways}

    A way is a set of runs that take the same steps. Its variables are those of the root, then the times of
    waiting for splits, in order. *)

type way = {
  set : Scc_polyhedra.Polyhedron.t;
  here : Scc_polyhedra.Linear.t array;  (** the variables of the current node *)
  taken : (Zone_steps.step * Scc_polyhedra.Linear.t option) list;
  (** the last first, with the time that passes; forms may know fewer variables than the set has now *)
  length : int;  (** how many steps have been taken *)
  names : int array;  (** for each leaf of the node, which one of the root it is (rule Symmetry) *)
}

val extended : int -> Scc_polyhedra.Linear.t -> Scc_polyhedra.Linear.t
(** [extended n f] is a form over the first variables as a form over [n] variables. *)

val start : Zone.t -> Scc_polyhedra.Polyhedron.t -> way
(** [start root set] is the way without steps from a part of a root. *)

val extend : way -> int -> way
(** [extend way n] has [n] more variables, the last ones, which are unconstrained. *)

val enter : way -> Scc_polyhedra.Polyhedron.t -> way * Scc_polyhedra.Linear.t array
(** [enter way set] restricts the way to those runs whose node is in the set. The set is over the variables of
    the node, and perhaps others, which become new variables of the way. It also returns the variables of the
    set as forms. *)

val along : way -> Zone_graph.edge -> way
(** [along way edge] is the way after one more step, for the runs that satisfy the guard of the edge. *)

val sample : way -> Rat.t array option
(** One run of the way: with weak splits at once where possible, the first ones first, and otherwise in the
    relative interior. The array has a value for each variable. [None] if the way has no runs. *)

(** {1 Runs to a place} *)

val run : Zone_graph.t -> Search_sets.place -> t
(** A run along the path by which the node was found first. Weak splits are made at once where possible. The
    end is in the relative interior of all states that this path leads to. *)

val run_within : Zone_graph.t -> Search_sets.place -> Scc_polyhedra.Polyhedron.t -> t option
(** [run_within graph place values] is {!run} restricted to values of the parameters in a polyhedron. [None] if
    there are none. *)

(** One run out of many: values of the parameters, and instants of splits, for which a run goes along the nodes of
    a graph to a certain place. *)

open Scc_exact
open Scc_semantics

type step =
  | Happens of Transition.label
  (** as leaves are called at the start; processes are told by some leaf of theirs *)
  | Passes of Rat.t  (** until what comes next *)
  | Passes_some of Rat.t  (** less than that, to a weak split; more than 0 *)

type t = {
  values : Rat.t array;  (** of the parameters *)
  steps : step list;
  offset : Rat.t;  (** the time that passes after the steps *)
}

(** {1 Ways}

    Many runs that take the same steps: over the variables of the root that they start in, and the times that they
    wait for splits, in order. *)

type way = {
  set : Scc_polyhedra.Polyhedron.t;
  here : Scc_polyhedra.Linear.t array;  (** the variables of the node that they have come to *)
  taken : (Zone_steps.step * Scc_polyhedra.Linear.t option) list;
  (** the last first, with the time that passes; forms may know fewer variables than the set has now *)
  length : int;  (** how many steps have been taken *)
  names : int array;  (** for each leaf of the node, which one of the root it is (rule Symmetry) *)
}

val extended : int -> Scc_polyhedra.Linear.t -> Scc_polyhedra.Linear.t
(** A form over the first variables, as one over so many. *)

val start : Zone.t -> Scc_polyhedra.Polyhedron.t -> way
(** In a root, from a part of it. *)

val extend : way -> int -> way
(** Over as many variables more, the last ones, of which nothing is said. *)

val enter : way -> Scc_polyhedra.Polyhedron.t -> way * Scc_polyhedra.Linear.t array
(** Where its node is in a set over the variables of the node, and perhaps others, which are new variables: these
    variables as forms. *)

val along : way -> Zone_graph.edge -> way

val sample : way -> Rat.t array option
(** One run: with weak splits at once where they may be, the first ones first, and else in the relative
    interior. *)

(** {1 Runs to a place} *)

val run : Zone_graph.t -> Search_sets.place -> t
(** By the way that the node was found first, with weak splits at once where they may be, to a point in the
    relative interior of all that lead there. *)

val run_within : Zone_graph.t -> Search_sets.place -> Scc_polyhedra.Polyhedron.t -> t option
(** The same for values of the parameters in a polyhedron over them, if there are any. *)

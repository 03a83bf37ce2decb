(** One run out of many: values of the parameters, and instants of splits, for which a run goes along the nodes of
    a graph to a certain place. *)

open Scc_exact
open Scc_semantics

type step =
  | Happens of Transition.label
  | Passes of Rat.t  (** until what comes next *)
  | Passes_some of Rat.t  (** less than that, to a weak split; more than 0 *)

type t = {
  values : Rat.t array;  (** of the parameters *)
  steps : step list;
  offset : Rat.t;  (** the time that passes after the steps *)
}

val run : Zone_graph.t -> Search_sets.place -> t
(** By the way that the node was found first, with weak splits at once where they may be, to a point in the
    relative interior of all that lead there. *)

val run_within : Zone_graph.t -> Search_sets.place -> Scc_polyhedra.Polyhedron.t -> t option
(** The same for values of the parameters in a polyhedron over them, if there are any. *)

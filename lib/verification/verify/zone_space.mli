(** The graph of all zones of a model (rule Zones), as far as it was explored: for those who export it. *)

open Scc_calculus
open Scc_semantics
open Scc_symbolic

type t = {
  semantics : Semantics.t;
  graph : Zone_graph.t;
  stopped_by : Verdict.truncation list;  (** the bounds that left something unexplored *)
  faults : Scc_base.Diag.t list;  (** why what comes of some zone is not known (SC0901) *)
}

val explore :
  Joint_check.options -> Semantics.t -> Uncertain.t -> declared:State.t -> (t, Zone_check.fault) result
(** Breadth-first, within the bounds of the options, without reductions. Zones have the time where the model keeps
    it, or time is bounded. *)

val model : t -> Model.t

val complete : t -> bool
(** Every zone is expanded, and nothing was left out as it is late. *)

val unexpanded : t -> int
(** How many zones have edges that are not known. *)

val roots : t -> int list
(** The numbers of the zones of the start, increasing. *)

val rests : Zone_graph.node -> Scc_polyhedra.Polyhedron.t list
(** From where nothing comes next: time may pass for ever. *)

val edges : t -> int
(** How many are known. *)

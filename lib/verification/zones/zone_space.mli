(** The graph of all zones of a model (rule Zones), as far as it was explored: for export. *)

open Scc_calculus
open Scc_semantics
open Scc_symbolic
open Scc_verify

type t = {
  semantics : Semantics.t;
  graph : Zone_graph.t;
  stopped_by : Verdict.truncation list;  (** the bounds that left something unexplored *)
  faults : Scc_base.Diag.t list;  (** the reasons why successors of some zone are not known (SC0901) *)
}

val explore :
  Setup.t -> Semantics.t -> Uncertain.t -> declared:State.t -> (t, Zone_check.fault) result
(** The graph, breadth-first, within the bounds of the options, without reductions. Zones have the time as a
    coordinate if the model keeps it, or if time is bounded. *)

val model : t -> Model.t
(** The model of the semantics. *)

val complete : t -> bool
(** [complete t] is true if every zone is expanded, and nothing was left out for the bound of time. *)

val unexpanded : t -> int
(** The number of zones whose edges are not known. *)

val roots : t -> int list
(** The numbers of the zones of the start, increasing. *)

val rests : Zone_graph.node -> Scc_polyhedra.Polyhedron.t list
(** The regions of a node after which no event is due: time may pass for ever. Weak splits may be possible all
    the same. *)

val edges : t -> int
(** The number of known edges. *)

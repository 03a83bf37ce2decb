(** The zones that an exploration left open, and a run to the nearest of them. *)

open Scc_calculus
open Scc_semantics
open Scc_polyhedra
open Scc_symbolic
open Scc_verify

val reason :
  Lost.t -> Semantics.t -> Uncertain.t -> declared:State.t -> sliced:bool -> Zone_graph.t ->
  unknown:Union.t -> Verdict.reason option
(** The number of unexpanded zones that are reached for values with an [unknown] verdict, and a run to the
    first of them, for some of these values. [None] if there are none, if they are too many to compute their
    values, if no time was left, or if the run was lost. *)

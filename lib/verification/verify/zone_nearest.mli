(** What an exploration of zones left open, and a run to the nearest of it. *)

open Scc_calculus
open Scc_semantics
open Scc_polyhedra
open Scc_symbolic

val reason :
  Lost.t -> Semantics.t -> Uncertain.t -> declared:State.t -> sliced:bool -> Zone_graph.t ->
  unknown:Union.t -> Verdict.reason option
(** Of the zones that were not expanded, those that are reached for values for which a verdict is [unknown]: how
    many, and a run to the first of them, for some of these values. [None]: there are none, they are too many to be
    asked which values lead there, there was no time left, or the run was lost. *)

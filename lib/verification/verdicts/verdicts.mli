(** Verdicts for the checks of a loaded model, by states, zones or invariants. *)

open Scc_base
open Scc_calculus
open Scc_property
open Scc_verify
open Scc_loading

val over_zones : Loaded.t -> bool
(** [over_zones l] is true if the model is explored over zones: for all values and instants that it leaves open
    (rule Zones). *)

val uncertain : Loaded.t -> Uncertain.t
(** The numbers that depend on parameters with ranges; constants if there are no ranges. *)

val refused : Loaded.t -> prove:bool -> (unit, Diag.t list) result
(** SC0901 if the model is explored over zones, or for an invariant with [prove], and its numbers would not be
    affine, or chance decides what is not followed. *)

val graph_refused : Loaded.t -> (unit, Diag.t list) result
(** SC0901 if the model is explored over zones, and the graph of its zones cannot be written: numbers would not be
    affine, or laws of motion or lots come in. *)

val report :
  Setup.t -> Loaded.t -> initial:State.t -> exactly:bool -> premises:Property.check list ->
  Property.check list ->
  (Check.report, Diag.t list) result
(** The verdicts of checks: by {!Zone_check.run}, with [exactly], or by {!Check.run}. With
    {!Setup.t.prove} invariants come first, as far as they decide (rule Invariants). Outcomes of premises
    ({!Loaded.t}) come after those of the checks. The errors: numbers of the model would not be affine
    (SC0901), or the declared state is not well-formed for some values. *)

(** Verdicts for the checks of a loaded model, by whatever way of exploring it takes. *)

open Scc_base
open Scc_calculus
open Scc_property
open Scc_verify

val over_zones : Loaded.t -> bool
(** Of all values and instants that the model leaves open (rule Zones). *)

val uncertain : Loaded.t -> Uncertain.t
(** What depends on the parameters with ranges, if there are any. *)

val refused : Loaded.t -> prove:bool -> (unit, Diag.t list) result
(** Numbers of the model would not be affine, and it is looked at over zones, or for an invariant (SC0901). *)

val report :
  Check.options -> Loaded.t -> initial:State.t -> exactly:bool -> premises:Property.check list ->
  Property.check list ->
  (Check.report, Diag.t list) result
(** By {!Zone_check.run}, with [exactly], or by {!Check.run}; with {!Check.options.prove} by invariants first, as
    far as they decide (rule Invariants). Outcomes of premises ({!Loaded.t}) come after those of the checks. The
    error: numbers of the model would not be affine (SC0901), or the declared state is not well-formed for some
    values. *)

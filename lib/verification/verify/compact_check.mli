(** {!Joint_check} with hash compaction. *)

open Scc_calculus
open Scc_semantics
open Scc_property

val serves : Property.check -> bool
(** Whether it will do for a property: searches (EF, AG) for state predicates without a bound of time, and what
    [not], [and] and [or] make of them. *)

val check :
  Joint_check.options -> capacity:int -> Semantics.t -> initial:State.t -> Property.check list ->
  Joint_check.result
(** Of properties that it serves. What is found is as sure as ever; what is not may have been left out. Cycles
    without duration are not looked for. *)

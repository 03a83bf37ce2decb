(** {!Joint_check} with hash compaction. *)

open Scc_calculus
open Scc_semantics
open Scc_property

val serves : Property.check -> bool
(** [serves check] is true if hash compaction can decide the property. It can for searches (EF, AG) for state
    predicates without a bound of time, and for combinations of them with [not], [and] and [or]. *)

val check :
  Setup.t -> capacity:int -> Semantics.t -> initial:State.t -> Property.check list ->
  Joint_check.result
(** The result for properties that it {!serves}. A state that is found is found for certain; other states may
    have been omitted. Cycles without duration are not searched. *)

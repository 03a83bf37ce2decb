(** The formulas that tell graphs apart, read from their texts and evaluated by the definitions. *)

open Scc_equivalence

type t

val parse : string -> t
(** Labels are words without brackets. Fails on what it cannot read. *)

val holds : Graph.t -> t -> int -> bool
(** In a state of a small graph. *)

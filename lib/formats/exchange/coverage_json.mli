(** Coverage as JSON ([specs/schema/check.schema.json]), and the names that reports give to what is covered. *)

open Scc_calculus
open Scc_verify

val owner : Model.t -> Coverage.summand -> string
(** Where a summand stands: ["Empty on Enzyme"], or ["p"] for one that is written at the body p. *)

val term : Model.t -> Coverage.summand -> string
(** The summand in the syntax of the language. *)

val behaviour : Model.t -> Coverage.behaviour -> string
(** ["Empty on Enzyme"]. *)

val json : Explored.t -> Coverage.t -> Json.t
(** Of what was explored; says whether that is all. *)

(** Coverage as JSON ([specs/schema/check.schema.json]), and the names of its items in reports. *)

open Scc_calculus
open Scc_verify
open Scc_json

val owner : Model.t -> Coverage.summand -> string
(** The owner of a summand: ["Empty on Enzyme"] for a definition, or ["p"] for a summand that is written at the
    body p. *)

val term : Model.t -> Coverage.summand -> string
(** The summand in the syntax of the language. *)

val behaviour : Model.t -> Coverage.behaviour -> string
(** The definition and the species, such as ["Empty on Enzyme"]. *)

val format : (Explored.t * Coverage.t, unit) Json_format.t
(** The format of the coverage of an exploration. It says as well if the exploration is complete. *)

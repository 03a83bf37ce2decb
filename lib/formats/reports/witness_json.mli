(** Runs that show a verdict, as JSON ([specs/schema/check.schema.json]). *)

open Scc_semantics
open Scc_explain
open Scc_json

val file : string
(** The name of the file of the schema, for {!Json_format.named}. *)

(** A witness with the model that its property is about. *)
type t = {
  given : Semantics.t;
  witness : Witness.t;
  full : bool;  (** all steps are included; else the first and the last 100 of them *)
}

val format : (t, unit) Json_format.t
(** The format of a witness. *)

val contrast : t -> (int * t) option
(** [contrast w] is {!Witness.otherwise} of the witness: the number of steps in common, and the other run. *)

val otherwise : (int * t, unit) Json_format.t
(** The format of {!contrast}. *)

val argument_format : (Witness.argument, unit) Json_format.t
(** The format of the argument by which a witness proves a property. *)

val finish : Witness.t -> string
(** The word for the end of the run: ["state"], ["instant"], ["rests"], … *)

val instant : (Scc_exact.Algebraic.t, unit) Json_format.t
(** The format of a real instant: rational bounds of it, which are equal if it is rational, and its text. *)

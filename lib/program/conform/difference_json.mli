(** The result of {!Difference} as JSON ([specs/schema/diff.schema.json]). *)

open Scc_exact
open Scc_json

(** Two traces with their first difference. *)
type t

val format : (t, unit) Json_format.t
(** The format of {!json}. *)

val json : Recorded.t -> Recorded.t -> tolerance:Rat.t -> exit:int -> Difference.t option -> Json.t
(** The result as a document. *)

(** The report of [scc decompose] as JSON (see [specs/schema/decomposition.schema.json]). *)

open Scc_concave
open Scc_json

(** A decomposition with what its report says beside it. *)
type t

val format : (t, unit) Json_format.t
(** The format of {!document}. *)

val document :
  name:string ->
  exit:int ->
  source:Scc_runs.Diag_json.source ->
  diagnostics:Scc_base.Diag.t list ->
  mended:(string * string) list ->
  Parts.t ->
  Json.t
(** The whole document. [mended] is the changes of {!Mended_json}. *)

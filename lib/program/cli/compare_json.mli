(** The report of [scc compare] as JSON ([specs/schema/compare.schema.json]). *)

open Scc_json

(** A comparison with its diagnostics. *)
type t

val format : (t, unit) Json_format.t
(** The format of {!json}. *)

val json : Console.t -> Compare_report.t -> Json.t
(** The whole document. *)

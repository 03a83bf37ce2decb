(** A {!Report} as JSON ([specs/schema/conform.schema.json]). *)

open Scc_base
open Scc_exact
open Scc_json
open Scc_runs

val format : (Report.t * int * (Diag_json.source * Diag.t list), unit) Json_format.t
(** The format of {!json}: a result, the exit code, and diagnostics. *)

val json : Report.t -> exit:int -> source:Diag_json.source -> diagnostics:Diag.t list -> Json.t
(** The result as a document. *)

val about : (Rat.t, unit) Json_format.t
(** The format of a number: [{"exact": "5/4", "about": "1.25"}]; the second member is for readers. *)

val event : (Recorded.event, unit) Json_format.t
(** The format of a recorded event. *)

val event_of : Recorded.item -> Recorded.event option
(** The event of an item, if it is one. *)

val trace_fields : (Recorded.t, unit) Json_format.members list
(** The members [file] and [format] about a trace. *)

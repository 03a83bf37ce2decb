(** The causes of a fact, as JSON (see [specs/schema/explain.schema.json]). *)

open Scc_base
open Scc_property
open Scc_explain
open Scc_loading
open Scc_json
open Scc_runs

(** An explanation with its run. *)
type t = {
  origin : Origin.t;
  check : Property.check option;  (** the check that the fact is about; without one, the fact is the last event *)
  ending : Replay.ending;  (** the end of the run *)
  explanation : Omission.t;
  diagnostics : Diag.t list;
  exit : int;
}

val format : (Diag_json.source * t, unit) Json_format.t
(** The format of {!document}. *)

val document : source:Diag_json.source -> t -> Json.t
(** The whole document. [source] returns the text of a file by its name, for lines and columns. *)

(** What a fact depends on, as JSON (see [specs/schema/explain.schema.json]). *)

open Scc_base
open Scc_property
open Scc_explain
open Scc_session

type t = {
  origin : Origin.t;
  check : Property.check option;  (** that the fact is about; otherwise it is the last event *)
  ending : Replay.ending;  (** how the run stands where it is left *)
  explanation : Omission.t;
  diagnostics : Diag.t list;
  exit : int;
}

val document : source:(string -> Source.t option) -> t -> Json.t

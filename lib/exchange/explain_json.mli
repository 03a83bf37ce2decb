(** What a fact depends on, as JSON (see [specs/schema/explain.schema.json]). *)

open Scc_base
open Scc_exact
open Scc_property
open Scc_explain

type t = {
  name : string option;
  digest : string;
  parameters : (string * Rat.t) list;
  check : Property.check option;  (** that the fact is about; otherwise it is the last event *)
  explanation : Omission.t;
  diagnostics : Diag.t list;
  exit : int;
}

val document : source:(string -> Source.t option) -> t -> Json.t

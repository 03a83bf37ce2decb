(** The graph of zones of a model as JSON: [specs/schema/zones.schema.json] describes it. *)

open Scc_json

val format : (Zone_exported.t, unit) Json_format.t
(** The format of the document. *)

val write : Zone_exported.t -> (string -> unit) -> unit
(** Writes the document piece by piece, with a line for each zone. *)

(** The graph of zones of a model as JSON: [specs/schema/zones.schema.json] describes it. *)

val version : int
(** The version of the format: 1. *)

val write : Zone_exported.t -> (string -> unit) -> unit
(** Writes the document piece by piece, with a line for each zone. *)

(** The graph of zones of a model as JSON: [specs/schema/zones.schema.json] describes it. *)

val write : Zone_exported.t -> (string -> unit) -> unit
(** Writes the document piece by piece, with a line for each zone. *)

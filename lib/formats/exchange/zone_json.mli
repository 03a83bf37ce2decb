(** The graph of zones of a model as JSON: [specs/schema/zones.schema.json] describes it. *)

val version : int
(** Of the format. *)

val write : Zone_exported.t -> (string -> unit) -> unit
(** Piece by piece, a line for each zone. *)

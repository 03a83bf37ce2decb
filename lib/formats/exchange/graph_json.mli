(** An explored graph as JSON (see [specs/schema/graph.schema.json]): states in full, transitions, and which
    predicates of the checks hold where. *)

val version : int

val write : Exported.t -> Labelling.t -> (string -> unit) -> unit
(** One line for each state. *)

(** An explored graph as JSON (see [specs/schema/graph.schema.json]): states in full, transitions, and the
    predicates of the checks that hold in each state. *)

(** A graph with its labelling. *)
type t

val format : (t, unit) Scc_json.Json_format.t
(** The format of the document. *)

val write : Exported.t -> Labelling.t -> (string -> unit) -> unit
(** Writes the document, with one line for each state. *)

(** An explored graph as JSON (see [specs/schema/graph.schema.json]): states in full, transitions, and the
    predicates of the checks that hold in each state. *)

open Scc_json

val check : (Scc_property.Property.check, unit) Json_format.t
(** The format of a check: its name and its text. *)

(** A graph with its labelling. *)
type t

val format : (t, unit) Json_format.t
(** The format of the document. *)

val write : Exported.t -> Labelling.t -> (string -> unit) -> unit
(** Writes the document, with one line for each state. *)

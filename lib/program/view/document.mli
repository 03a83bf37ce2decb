(** The content of a page, as one JSON document (see [specs/schema/view.schema.json]). *)

open Scc_property
open Scc_loading
open Scc_json

(** A document. *)
type t = {
  loaded : Loaded.t;
  name : string;  (** of the file of the model *)
  tables : Tables.t;
  states : States.t;
  plots : Property.num list;
  graph : Graph.t option;  (** the exploration, if the document has all states up to a bound *)
  runs : Runs.t list;
  where : Regions.t option;  (** of a model with ranges *)
  spread : Spread.t option;  (** of runs of a simulation: the values of all its runs *)
}

val format : (t * Bodies.t list, unit) Json_format.t
(** The format of a document with the leaves of its model. *)

val write : t -> (string -> unit) -> unit
(** Writes the document. *)

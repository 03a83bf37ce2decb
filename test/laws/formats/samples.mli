(** Random documents of schemas, and random changes of documents. *)

open Scc_json

val document : Random.State.t -> Json_schema.t -> Json.t
(** A document of the schema, further keywords ({!Json_schema.Also}) left aside. *)

val changed : Random.State.t -> Json.t -> string * Json.t
(** The document with one change, and the kind of that change. *)

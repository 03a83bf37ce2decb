(** Diagnostics as JSON (see [specs/schema/diagnostics.schema.json]). *)

open Scc_base
open Scc_json

val diagnostic : source:(string -> Source.t option) -> Diag.t -> Json.t
(** A diagnostic. Places are offsets in bytes. If [source] returns the text of the file, they also have line and
    column from 1; columns count code points. *)

val document : source:(string -> Source.t option) -> exit:int -> Diag.t list -> Json.t
(** The document that a command prints instead of its report if it cannot make one. *)

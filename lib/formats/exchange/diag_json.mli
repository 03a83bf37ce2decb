(** Diagnostics as JSON (see [specs/schema/diagnostics.schema.json]). *)

open Scc_base

val diagnostic : source:(string -> Source.t option) -> Diag.t -> Json.t
(** Places are given as offsets in bytes and, when [source] finds the text, as line and column from 1
    (columns count code points). *)

val document : source:(string -> Source.t option) -> exit:int -> Diag.t list -> Json.t
(** What a command prints instead of its report when it cannot make one. *)

(** The report of [scc decompose] as JSON (see [specs/schema/decomposition.schema.json]). *)

open Scc_drawn

val document : name:string -> exit:int -> Parts.t -> Json.t

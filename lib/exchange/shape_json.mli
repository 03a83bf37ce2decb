(** The report of [scc shape] as JSON (see [specs/schema/shape.schema.json]). *)

open Scc_geometry

val document : name:string -> exit:int -> Solid_report.t -> Json.t

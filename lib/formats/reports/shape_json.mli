(** The report of [scc shape] as JSON (see [specs/schema/shape.schema.json]). *)

open Scc_geometry
open Scc_json

val document :
  name:string ->
  exit:int ->
  ?mended:(string * string) list ->
  ?snap:Scc_exact.Rat.t * Scc_snap.Snap.snapped ->
  ?outer:Scc_snap.Outer.t ->
  Solid_report.t ->
  Json.t
(** The whole document. [mended] is the changes of {!Mended_json}. [snap] is the distance within which the shape
    was snapped, and the result. [outer] says that the shape has fewer faces than the hull. *)

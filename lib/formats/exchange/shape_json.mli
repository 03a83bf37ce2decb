(** The report of [scc shape] as JSON (see [specs/schema/shape.schema.json]). *)

open Scc_geometry

val document :
  name:string ->
  exit:int ->
  ?mended:(string * string) list ->
  ?snap:Scc_exact.Rat.t * Scc_snap.Snap.snapped ->
  ?outer:Scc_snap.Outer.t ->
  Solid_report.t ->
  Json.t
(** [mended]: {!Mended_json}. [snap]: within which distance it was snapped, and what that did. [outer]: that it has
    fewer faces than the hull. *)

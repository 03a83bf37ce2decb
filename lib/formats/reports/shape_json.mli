(** The report of [scc shape] as JSON (see [specs/schema/shape.schema.json]). *)

open Scc_geometry
open Scc_json

(** A report with what was done to the shape first. *)
type t

val format : (t, unit) Json_format.t
(** The format of {!document}. *)

val fault : ((Solid_report.t * Polyhedron_fault.t), unit) Json_format.t
(** The format of a fault. *)

val faults : (Solid_report.t, unit) Json_format.t
(** The format of the member [faults]. *)

val warning : (Scc_base.Diag.t, unit) Json_format.t
(** The format of a member of [warnings]. *)

val report_members : (Solid_report.t, unit) Json_format.members
(** The members that are about the solid alone. *)

val document :
  name:string ->
  exit:int ->
  source:Scc_runs.Diag_json.source ->
  diagnostics:Scc_base.Diag.t list ->
  ?mended:(string * string) list ->
  ?snap:Scc_exact.Rat.t * Scc_snap.Snap.snapped ->
  ?outer:Scc_snap.Outer.t ->
  Solid_report.t ->
  Json.t
(** The whole document. [mended] is the changes of {!Mended_json}. [snap] is the distance within which the shape
    was snapped, and the result. [outer] says that the shape has fewer faces than the hull. *)

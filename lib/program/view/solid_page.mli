(** The page of [scc shape --view]: a solid with the names of its faces, edges and vertices. A solid that is
    refused has its faults at their places. *)

open Scc_geometry

val write : name:string -> Solid_report.t -> (string -> unit) -> unit
(** Writes the page of a solid with this name. *)

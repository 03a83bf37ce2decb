(** The page of [scc shape --view]: a solid with the names of its faces, edges and vertices; of one that is
    refused, what is wrong, at its place. *)

open Scc_geometry

val write : name:string -> Solid_report.t -> (string -> unit) -> unit

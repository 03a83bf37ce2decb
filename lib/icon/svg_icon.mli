(** Drawings in SVG. *)

open Scc_base

val is : string -> bool
val read : resolution:int -> path:string -> string -> (Raster.t, Diag.t) result

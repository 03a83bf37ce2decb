(** Netpbm's pictures: PBM, PGM and PPM, as text (P1, P2, P3) and binary (P4, P5, P6). The first picture of a file
    alone is read. Samples are taken to 256 levels. *)

open Scc_base

val is : string -> bool
(** By the first bytes. *)

val read : path:string -> string -> (Raster.t, Diag.t) result

(** Netpbm's pictures: PBM, PGM and PPM, as text (P1, P2, P3) and binary (P4, P5, P6). Only the first picture
    of a file is read. Samples are scaled to 256 levels. *)

open Scc_base

val is : string -> bool
(** [is text] is true if the first bytes are those of a Netpbm file. *)

val read : path:string -> string -> (Raster.t, Diag.t) result
(** The first picture of a file. Faults: {!Picture_fault}. *)

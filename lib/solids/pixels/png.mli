(** PNG (Portable Network Graphics, second edition): all colour types, depths and interlaced pictures, with
    checksums and transparency, by zlib for the compressed data. Samples are taken to 256 levels by their high
    bits, and colours are taken as they are (gamma and profiles are skipped). *)

open Scc_base

val is : string -> bool
(** By the first bytes. *)

val read : path:string -> string -> (Raster.t, Diag.t) result
(** Its size is looked at first, and never more memory taken than a picture of that size needs. *)

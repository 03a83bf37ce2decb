(** PNG (Portable Network Graphics, second edition): all colour types, depths and interlaced pictures, with
    checksums and transparency, by zlib for the compressed data. Samples are reduced to 256 levels by their
    high bits. Colours are used as they are (gamma and profiles are skipped). *)

open Scc_base

val is : string -> bool
(** [is text] is true if the first bytes are those of a PNG file. *)

val read : path:string -> string -> (Raster.t, Diag.t) result
(** The picture of a file. Its size is checked first; the memory used is at most that of a picture of that
    size. *)

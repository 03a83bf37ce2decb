(** Pictures that shapes are made of, from files: PNG, Netpbm (PBM, PGM, PPM) and SVG, told apart by what is in
    them. *)

open Scc_base

val read : ?resolution:int -> path:string -> string -> (Raster.t, Diag.t) result
(** [resolution] is how many pixels the longer side of an SVG drawing has, 128 if not told; other pictures have
    theirs. Faults: {!Picture_fault}. *)

val default_resolution : int

val is_text : string -> bool
(** A drawing whose faults have places in its text. *)

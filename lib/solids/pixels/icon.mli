(** Pictures for shapes, from files: PNG, Netpbm (PBM, PGM, PPM) and SVG, which are recognised by their
    contents. *)

open Scc_base

val read : ?resolution:int -> path:string -> string -> (Raster.t, Diag.t) result
(** The picture of a file. [resolution] is the number of pixels of the longer side of an SVG drawing,
    {!default_resolution} if it is not given; other pictures have their own. Faults: {!Picture_fault}. *)

val read_warned : ?resolution:int -> path:string -> string -> (Raster.t * Diag.t list, Diag.t) result
(** [read_warned ?resolution ~path text] is the picture of a file, as {!read} gives it, with warnings (SC0324) of
    what is left out of an SVG drawing: programs, and the mixing of colours. *)

val default_resolution : int
(** The number of pixels of the longer side of an SVG drawing: 128. *)

val is_text : string -> bool
(** [is_text text] is true for an SVG drawing, whose faults have places in its text. *)

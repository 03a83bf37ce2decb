(** Drawings in SVG: the filled areas of paths, rectangles, circles, ellipses and polygons, in groups, with
    transforms, one over the other. A pixel is painted when its centre is inside, which is decided exactly for
    outlines whose curves are within 1/64 of a pixel ({!Svg_path}). What would be seen otherwise and is not read
    (strokes, text, gradients, style sheets, clips, references, declarations of a document type) is refused. *)

open Scc_base

val is : string -> bool
(** Whether it may be one: XML. *)

val read : resolution:int -> path:string -> string -> (Raster.t, Diag.t) result
(** The longer side of its viewBox, or else of its width and height, becomes [resolution] pixels. SC0340 and
    SC0341 at their places; time and memory are bounded. *)

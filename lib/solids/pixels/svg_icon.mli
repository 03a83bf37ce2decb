(** Drawings in SVG: the filled areas of paths, rectangles, circles, ellipses and polygons, in groups, with
    transforms, one over the other. A pixel is painted if its centre is inside. That is decided exactly, for
    outlines whose curves are within 1/64 of a pixel ({!Svg_path}). Each element, attribute
    and property is read, is known to paint nothing, or is refused ({!Svg_table}). Refused are strokes, text,
    gradients, style sheets, clips, references, and declarations of a document type. *)

open Scc_base

val is : string -> bool
(** [is text] is true if the text may be a drawing: it begins as XML. *)

val read : resolution:int -> path:string -> string -> (Raster.t, Diag.t) result
(** The picture of a drawing. The longer side of its viewBox, or else of its width and height, becomes
    [resolution] pixels. Errors SC0340 and SC0341 are located in the file. Time and memory are bounded. *)

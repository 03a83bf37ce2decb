(** Drawings in SVG: the filled areas and the strokes of shapes, in groups and where they are used, with
    transforms, style sheets and clip paths, one over the other ({!Svg_layer}). A pixel is painted if its centre is
    inside, and seen if it is at least half opaque in the end.
    That is decided exactly, for outlines whose curves are within 1/64 of a pixel ({!Svg_polygon},
    {!Svg_stroke}). Visible features that are not supported are refused: text, pictures, patterns, masks,
    filters, markers, declarations of a document type. *)

open Scc_base

val is : string -> bool
(** [is text] is true if the text may be a drawing: it begins as XML. *)

val read : resolution:int -> path:string -> string -> (Raster.t * Diag.t list, Diag.t) result
(** The picture of a drawing, with warnings (SC0324) of programs, which are not run, and of colours that would be
    mixed. The longer side of what is seen becomes [resolution] pixels. That is the viewBox, or
    else the width and height. If these have other proportions than the viewBox, by half of a pixel or more,
    what is seen is longer one way, as [preserveAspectRatio] says. Errors SC0340 and SC0341 are located in the
    file. Time and memory are bounded. *)

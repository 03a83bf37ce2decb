(** Drawings of shapes in SVG, from two opposite sides, so that each face is visible from one of them. They have
    the names of faces and vertices; hidden edges are dashed. A shape that is refused has the witness of each
    fault, and of each failing condition of Definition 4.3, at its place, numbered as in the list below the
    drawing. *)

open Scc_exact
open Scc_geometry

(** The viewpoint and the width. *)
type options = {
  from : Vec.t;  (** the first side from which the shape is drawn; not zero *)
  up : Vec.t;  (** upwards in the picture, unless that is where it is seen from *)
  width : int;  (** in pixels, within {!Sheet.width_limits} *)
}

val default : options
(** The viewpoint of {!Picture.default}, and 900 pixels of width. *)

val svg : name:string -> options -> Solid_report.t -> string
(** The drawing of a shape by this name as the text of an SVG file. *)

(** Drawings of shapes in SVG, from two opposite sides, so that each face is seen on one of them: with the names of
    faces and vertices, hidden edges dashed; of a shape that is refused with the witness of each fault, and of each
    condition of Definition 4.3 that fails, at its place, numbered as they are told below. *)

open Scc_exact
open Scc_geometry

type options = {
  from : Vec.t;  (** the first side from which it is seen; not zero *)
  up : Vec.t;  (** upwards in the picture, unless that is where it is seen from *)
  width : int;  (** in pixels, within {!Sheet.width_limits} *)
}

val default : options

val svg : name:string -> options -> Solid_report.t -> string

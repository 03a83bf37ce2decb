(** A picture of where checks hold, in SVG: the plane of two parameters, or the line of one, in one colour for each
    combination of outcomes, with a legend. The side of a border on which it belongs to the region has a whole
    line, the other one a dashed line; what has no area is drawn as lines and points; corners tell their exact
    coordinates when pointed at, in the colour of the region that they belong to. *)

open Scc_calculus

val svg : Ranges.t -> Plane.view -> (string * Where.t) list -> string
(** A whole file, light or dark as whoever looks at it prefers. The checks have different names, and these ranges.
    Everything is found in exact numbers, and its place in the picture is rounded to 1/100 of a pixel: the file
    says so. The same input gives the same bytes. *)

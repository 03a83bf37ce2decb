(** A picture of where checks hold, in SVG: the plane of two parameters, or the line of one, in one colour for
    each combination of outcomes, with a legend. A border has a solid line on the side of the region that it
    belongs to, and a dashed line on the other side. Sets without area are drawn as lines and points. Corners
    show their exact coordinates under the pointer, in the colour of their region. *)

open Scc_calculus

val svg : ?values:(string * Chances.t) list -> Ranges.t -> Plane.view -> (string * Where.t) list -> string
(** A whole file, light or dark as the viewer prefers. The checks, and the probabilities in [values], have
    different names, and these ranges. All computations are exact; places in the picture are rounded to 1/100 of a
    pixel, as the file says. The same input gives the same bytes. *)

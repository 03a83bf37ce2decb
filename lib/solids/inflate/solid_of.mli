(** The inflated shape as a solid: its front, and the mirror image of that behind, sewn together along the
    outline. It is closed, and does not meet itself: each side is a graph over the inside of the outline, one
    above 0 and the other one below. *)

open Scc_exact
open Scc_geometry

(** What was left out, all in pixels. *)
type gaps = {
  solution : Rat.t;  (** the heights over the centres of pixels, before simplification, from the exact ones *)
  surface : Rat.t;  (** the simplified front from the one over all pixels, upward or downward, anywhere *)
  outline : Rat.t;  (** the simplified outline from that around all pixels *)
}

type t = {
  mesh : Polyhedron.ifs;
  (** the middle of the picture is the origin, the x axis goes to its right, the y axis to its top, and the z axis
      towards whoever looks at it; faces are triangles, listed counter-clockwise from outside, the front's first *)
  holes : int;
  gaps : gaps;
}

val everything : Relief.t -> int
(** How many faces the solid has that is not simplified. *)

val make :
  progress:(float -> unit) -> faces:int option -> scale:Rat.t -> Relief.t -> (t, int) result
(** Of at most so many faces, all of them if not told; lengths are multiplied by [scale] > 0, those of {!gaps} are
    not. When there is no such solid, how many faces would have to be allowed. *)

(** Concave solids in convex parts, exactly. *)

open Scc_exact

val parts : ?tick:(unit -> unit) -> Vec.t array list -> Vec.t list list
(** From the surface of a closed solid without self-intersections, as convex polygons whose corners run
    counter-clockwise as seen from outside: the corners of convex parts without common inner points, which are
    together the solid ({!Cut}, {!Union}). [tick] is called again and again, and may raise. *)

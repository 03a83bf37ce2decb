(** The exact test of a point against a closed surface. *)

open Scc_exact
open Scc_geometry

val surface : Polyhedron.ifs -> int list -> Vec.t -> bool
(** [surface set faces x] is true if the point [x], which is on none of the faces, is inside the closed surface
    that they form. The faces are flat and simple, and each edge is shared with another of them. Near linear
    time; the orientation of the faces does not matter. *)

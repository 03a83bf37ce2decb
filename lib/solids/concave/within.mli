(** Whether a point is within a closed surface, exactly. *)

open Scc_exact
open Scc_geometry

val surface : Polyhedron.ifs -> int list -> Vec.t -> bool
(** [surface set faces x]: the faces are flat, simple, and have each of their edges in common with another one of
    them; x is on none. Near linear time; direction of the faces does not matter. *)

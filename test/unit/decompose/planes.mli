(** What polygons have in each plane. *)

open Scc_exact
open Scc_geometry

val area_vector : Vec.t array -> Vec.t
(** Twice the area of a flat polygon, along its normal. *)

val areas : Vec.t array list -> ((string * string) * string) list
(** Of each plane what looks to one side, less what looks to the other, where that is not 0: where two solids
    touch they cancel, and what is left of the faces of parts is the surface of the whole. Planes are told by
    normals that are not negative, and levels. *)

val faces : Polyhedron.t -> Vec.t array list

(** The geometry nodes of VRML and X3D, as polygons. *)

open Scc_exact

type t = {
  points : Vec.t array;
  faces : int array list;  (** corners of each face, counter-clockwise from outside *)
  cost : int;  (** what it takes from the bound on the size of all shapes of a file *)
  distance : Rat.t;  (** a bound of the Hausdorff distance from the surface that is meant; 0 if it is exact *)
}

val make : path:string -> room:int -> Scene.node -> t
(** The shape of a node whose role is [Geometry] in {!Scene_table}. Spheres, cylinders and cones are replaced by
    inscribed polyhedra ({!Curved}), within a hundredth of their radius. Squares of a grid of heights that are not
    flat are cut in two, and the distance is that from the other way to cut them. An {!Extrusion} can have many
    times the points that its text has numbers: more than [room] of them are a fault. Faults raise
    {!Scene.Refused}. *)

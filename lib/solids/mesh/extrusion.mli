(** The node [Extrusion] of VRML97 and X3D: a plane curve that is carried along a spine, as polygons.

    The curve stands in a frame at each point of the spine, scaled and turned by its own values. The frames are
    those of the specification: (0, 1, 0) turned into a straight spine, and otherwise tangent and normal of three
    neighbours. Directions of irrational length are rounded, with a proved distance. Caps are planar all the same.
    Sides that are not planar become two triangles each: the specification leaves open by which diagonal. *)

open Scc_exact

type t = {
  points : Vec.t array;  (** no two are equal *)
  faces : int array list;  (** counter-clockwise from outside, for a counter-clockwise curve *)
  distance : Rat.t;  (** a bound of the distance of the surface from either one that the node can mean *)
}

val make : path:string -> room:int -> Scene.node -> t
(** The surface of the node. Caps at both ends of a closed spine are no boundary, and are left out if they
    coincide. Faults raise {!Scene.Refused}: spines that point downwards, turn back or stand still (SC0321), for
    which the specification gives no frame, and more than [room] points (SC0320). *)

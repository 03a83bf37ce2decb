(** The surface of a solid that need not be convex: its faces, edges and corners.

    Faces of the set that are side by side in one plane are one region, and edges between regions that go
    straight on are one border; so triangles that a program made of a face are that face again. A region need
    not be convex. *)

open Scc_exact
open Scc_geometry

type region = {
  name : string;  (** of the first of its faces *)
  normal : Ivec.t;  (** outward, primitive *)
  level : Rat.t;  (** n . x of its points *)
  pieces : Vec.t array list;  (** convex polygons that it consists of, counter-clockwise from outside *)
}

type border = {
  segments : (Vec.t * Vec.t) list;
  between : int list;  (** the regions on its sides *)
  ends : int list;  (** the corners of the solid on it, by vertex *)
}

(** A face, edge or corner of the surface: the numbers of a region, of a border, of a vertex of the set. *)
type feature = Region of int | Border of int | Corner of int

type t = private {
  set : Polyhedron.ifs;
  regions : region array;
  borders : border array;
  region_of_face : int array;
  border_of_edge : (int * int, int) Hashtbl.t;  (** by the vertices, the lesser one first;
                                                    not of edges inside regions *)
  corners : bool array;  (** by vertex: whether borders of different directions meet at it *)
  corners_of_region : int list array;
  borders_of_region : int list array;
}

val make : Polyhedron.ifs -> t option
(** The faces are those of a closed solid without self-intersections, turned outward. [None] where one of them
    is no simple polygon. *)

val closure : t -> feature -> feature list
(** With the borders and corners of a region, and the corners of a border. *)

val normal : Polyhedron.ifs -> int array -> Vec.t
(** Of a face by its corners: twice its area, outward. *)

val area_vector : (int -> Vec.t) -> int -> Vec.t
(** [area_vector corner n] of a flat polygon with n corners: twice its area, along its normal. *)

val convex_corners : Polyhedron.ifs -> int array -> Vec.t -> int array list option
(** As {!convex_pieces}, by vertices. *)

val convex_pieces : Polyhedron.ifs -> int array -> Vec.t -> Vec.t array list option
(** Of a flat face with this normal; [None] if it is no simple polygon. *)

val volume : Polyhedron.ifs -> Rat.t
(** Of the solid that the faces bound; negative if they are turned inward. *)

val reflex_edges : t -> int
(** The number of borders at which the solid is not convex. A solid without any is convex, if it is in one
    piece; each needs a cut. *)

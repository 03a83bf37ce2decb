(** The surface of a solid that need not be convex: its faces, edges and corners.

    Adjacent faces of the set in one plane are one region. Edges between regions that continue each other in a
    straight line are one border. So triangles into which a program has cut a face are one face again. A region
    need not be convex. *)

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
  between : int list;  (** the regions that it bounds *)
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
  corners : bool array;  (** by vertex: true if borders of different directions meet at it *)
  corners_of_region : int list array;
  borders_of_region : int list array;
}

val make : Polyhedron.ifs -> t option
(** The surface of a closed solid without self-intersections, whose faces are turned outward. [None] if one of
    them is no simple polygon. *)

val closure : t -> feature -> feature list
(** The feature itself, and its boundary: the borders and corners of a region, the corners of a border. *)

val normal : Polyhedron.ifs -> int array -> Vec.t
(** [normal set face] is the vector along the outward normal of the face with these vertices whose length is
    twice the area of the face. *)

val area_vector : (int -> Vec.t) -> int -> Vec.t
(** [area_vector corner n] is the vector along the normal of the flat polygon with corners [corner 0] to
    [corner (n - 1)] whose length is twice its area. *)

val convex_corners : Polyhedron.ifs -> int array -> Vec.t -> int array list option
(** [convex_corners set face n] is {!convex_pieces} by vertices in place of points. *)

val convex_pieces : Polyhedron.ifs -> int array -> Vec.t -> Vec.t array list option
(** [convex_pieces set face n] is the face, flat and with the normal [n], as convex polygons without common
    inner points. [None] if it is no simple polygon. *)

val volume : Polyhedron.ifs -> Rat.t
(** The volume of the solid that the faces bound; negative if they are turned inward. *)

val reflex_edges : t -> int
(** The number of borders at which the solid is not convex. A solid in one piece is convex if it has none; each
    of them needs a cut. *)

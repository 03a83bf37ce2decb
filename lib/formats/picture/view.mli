(** Convex polyhedra as a {!Camera} sees them: their faces and edges in the plane of the picture. *)

open Scc_exact

(** A convex polyhedron where it stands. *)
type solid = {
  corners : Ivec.t array;  (** over [denominator] *)
  denominator : Z.t;  (** positive *)
  faces : int array array;  (** counterclockwise seen from outside *)
  edges : (int * int) array;
}

val of_placed : Scc_rigid.Placed.t -> solid

(** A face that is seen from its outer side, if nothing is in front of it. *)
type face = {
  body : int;  (** index of the solid *)
  face : int;
  polygon : Convex.t;
  sides : Ivec.t array;  (** of the polygon, {!Convex.sides} *)
  depth : Ivec.t;
  (** (a, b, c): at a point (x, y, w) of the picture the face is at depth (a x + b y + c w) / ([scale] w): the
      greater, the nearer *)
  scale : Z.t;  (** positive *)
  normal : Ivec.t;  (** outward, in the world *)
}

(** An edge of a face that is seen. *)
type edge = {
  body : int;
  edge : int;
  ends : Ivec.t * Ivec.t;  (** points of the picture, different *)
  left : face option;  (** the face on its left in the picture, of those that are seen *)
  right : face option;  (** where there is only one of both, the edge is part of the outline of the solid *)
}

type t = { faces : face array; edges : edge array; points : Ivec.t array array  (** of each solid its corners *) }

(** Points of space as a camera sees them. *)
type points = {
  world : Ivec.t array;  (** from the origin, over the denominator *)
  turned : Ivec.t array;  (** along the axes of the camera, over it *)
  flat : Ivec.t array;  (** in the picture *)
  over : Z.t;
}

val points : Camera.t -> origin:Ivec.t -> Ivec.t array -> Z.t -> points

val facing : body:int -> face:int -> points -> int array -> face option
(** The face with these corners, which are those of a convex polygon of a plane, counterclockwise seen from
    outside: [None] if it shows its inner side, or an edge. *)

val depth : points -> int -> Rat.t
(** Of a point, as those of faces. *)

val make : Camera.t -> origin:Ivec.t -> solid array -> t
(** [origin] comes to (0, 0), at depth 0. *)

val nearer : face -> face -> Ivec.t
(** [nearer f g], a line: positive where the first is in front of the second. Zero if they are of one plane. *)

val depth_at : face -> Ivec.t -> Rat.t
(** How deep the plane of a face is at a point of the picture. *)

val before : face -> Ivec.t -> Rat.t -> int
(** The sign of how much the face is in front of a point of the picture at a depth. *)

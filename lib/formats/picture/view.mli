(** Convex polyhedra in the view of a {!Camera}: their faces and edges in the plane of the picture. *)

open Scc_exact

(** A convex polyhedron at its place in the world. *)
type solid = Front.mesh = {
  corners : Ivec.t array;  (** over [denominator] *)
  denominator : Z.t;  (** positive *)
  faces : int array array;  (** counterclockwise seen from outside *)
  edges : (int * int) array;
}

val of_placed : Scc_rigid.Placed.t -> solid
(** The solid of a part at its place. *)

(** A face that shows its outer side to the camera; other faces may be in front of it. *)
type face = {
  body : int;  (** index of the solid *)
  face : int;
  polygon : Convex.t;
  sides : Ivec.t array;  (** of the polygon, {!Convex.sides} *)
  depth : Ivec.t;
  (** (a, b, c): at a point (x, y, w) of the picture the depth of the face is (a x + b y + c w) / ([scale] w).
      Greater depths are nearer *)
  scale : Z.t;  (** positive *)
  normal : Ivec.t;  (** outward, in the world *)
}

(** An edge of such a face. *)
type edge = {
  body : int;
  edge : int;
  ends : Ivec.t * Ivec.t;  (** points of the picture, different *)
  left : face option;  (** the face on its left in the picture, if that shows its outer side *)
  right : face option;  (** likewise on its right; an edge with only one of both is part of the outline *)
}

(** A view of solids. *)
type t = { faces : face array; edges : edge array; points : Ivec.t array array  (** the corners of each solid *) }

(** Points of space in the view of a camera. *)
type points = {
  world : Ivec.t array;  (** relative to the origin, times [over] *)
  turned : Ivec.t array;  (** components along the axes of the camera, times [over] *)
  flat : Ivec.t array;  (** in the picture *)
  over : Z.t;
  perspective : bool;
  (** the camera has an eye. Then all is relative to the eye, a point (x, y, z) / [over] of the axes is at (x,
      y) / -z of the picture, and its depth is [over] / -z *)
}

val points : Camera.t -> origin:Ivec.t -> Ivec.t array -> Z.t -> points
(** [points camera ~origin corners over] is the view of the points [corners] / [over]. They must be in front of
    the eye of the camera, if it has one. *)

val facing : body:int -> face:int -> points -> int array -> face option
(** [facing ~body ~face points corners] is the face with these corners, which form a convex polygon of a plane,
    counterclockwise from outside. It is [None] if the face shows its inner side or lies along the view. *)

val depth : points -> int -> Rat.t
(** [depth points i] is the depth of the point [i], on the scale of the depths of faces. *)

val make : Camera.t -> origin:Ivec.t -> solid array -> t
(** The view of solids. [origin] becomes the point (0, 0) of the picture, at depth 0, unless the camera has an
    eye. What is not in front of an eye is cut off; a solid of which nothing is left has no faces and no points.
*)

val nearer : face -> face -> Ivec.t
(** [nearer f g] is a line: it is positive where [f] is in front of [g]. It is zero if both are in one plane. *)

val depth_at : face -> Ivec.t -> Rat.t
(** [depth_at f p] is the depth of the plane of [f] at the point [p] of the picture. *)

val before : face -> Ivec.t -> Rat.t -> int
(** [before f p depth] is positive if [f] is in front of the point [p] of the picture at that depth, negative if
    it is behind, and 0 if it contains the point. *)

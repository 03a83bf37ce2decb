(** Convex polygons in space that cross, touch or cover each other, and their pieces between the others. *)

open Scc_geometry
open Scc_decompose

type t = private {
  face : int;  (** The number of what the polygon is a piece of. *)
  plane : Plane.t;
  corners : Homogeneous.t array;  (** Counter-clockwise as seen from in front of the plane. *)
  ids : int array;  (** A number for each corner, the same at the same place. *)
  box : Float_box.t;
}

val make : face:int -> ids:int array -> (int -> Homogeneous.t) -> (int -> Float_box.t) -> t
(** [make ~face ~ids place box] is the convex polygon with these corners, which has an area. The functions give the
    place of a number, and a box around it. *)

type segment
(** A part of the intersection of a polygon with another one, and a plane through it. *)

type met = {
  segments : segment list;
  over : int list;  (** The polygons of the same plane that have an area in common with this one, in order. *)
  touched : bool;
  (** True if another polygon may have more in common with this one than edges and corners of both. *)
}

val met : tick:(unit -> unit) -> t array -> met array
(** [met ~tick sheets] is what each polygon has in common with all others. [tick] is called for each pair of
    polygons whose boxes meet. *)

type piece = {
  polygon : Homogeneous.t array;
  parent : int;  (** -1 for none *)
  leaf : bool;
}

val pieces : tick:(unit -> unit) -> t -> met -> piece array
(** [pieces ~tick sheet met] are convex pieces of the polygon; the first one is the whole. A piece that is no
    leaf is the union of the two whose parent it is, which have greater numbers. Inner points of a leaf are in no
    polygon of another plane. Each polygon of the same plane contains all of the leaf or no inner point of it.
    [tick] is called for each piece. *)

val inner : Homogeneous.t array -> Homogeneous.t
(** [inner polygon] is a point inside of a convex polygon. *)

val holds : t -> Homogeneous.t -> bool
(** [holds sheet x] is true if the polygon contains the point [x] of its plane. *)

val over : t -> Homogeneous.t -> int
(** [over sheet x] is 1 if the polygon is over the point [x] and looks upward, -1 if it is over [x] and looks
    downward, and 0 if it is not over [x]. Over [x] is what a ray upwards meets strictly above [x]. The ray
    begins at (x + e, y + e'), with e far greater than e', and both smaller than anything else. So it meets no
    edge. *)

val on_edge : Homogeneous.t -> Homogeneous.t -> Homogeneous.t -> bool
(** [on_edge a b x] is true if [x] is on the segment from [a] to [b], and neither of them. *)

val farther : Homogeneous.t -> Homogeneous.t -> Homogeneous.t -> Homogeneous.t -> int
(** [farther a b x y] orders points of the line through [a] and [b] in the direction from [a] to [b]. *)

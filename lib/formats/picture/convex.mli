(** Convex polygons of a plane, exactly. Points are homogeneous: [(x, y, w)], primitive, with w > 0, is (x/w,
    y/w). A line is [(a, b, c)]: a x + b y + c w is positive to the left of it. *)

open Scc_exact

type t = Ivec.t array
(** The corners, counterclockwise, at least three; no three of them in one line. *)

val point : Z.t -> Z.t -> Z.t -> Ivec.t
(** [point x y w] is the point (x/w, y/w), for w > 0. *)

val place : Ivec.t -> Rat.t * Rat.t
(** The coordinates of a point. *)

val through : Ivec.t -> Ivec.t -> Ivec.t
(** The line from a point to another one, primitive. *)

val sides : t -> Ivec.t array
(** The lines along its sides, from each corner to the next. The polygon is to the left of all of them. *)

val cut : t -> Ivec.t -> t option * t option
(** The parts of a polygon to the left and to the right of a line; [None] for a part without area. *)

val split : t -> Ivec.t array -> (t * t list) option
(** The part of a polygon to the left of all lines, and the rest in disjoint pieces. It is [None] if that part
    has no area. *)

val contains : t -> Ivec.t -> bool
(** [contains t p] is true if [p] is inside the polygon or on one of its sides. *)

val inside : t -> Ivec.t -> bool
(** [inside t p] is true if [p] is inside the polygon and not on its sides. *)

val area2 : t -> Rat.t
(** Twice the area. *)

val middle : t -> Ivec.t
(** The mean of the corners, which is a point inside. *)

(** Convex polygons of a plane, exactly. Points are homogeneous: [(x, y, w)], primitive, with w > 0, is (x/w, y/w).
    A line is [(a, b, c)]: a x + b y + c w, which is positive to the left of it. *)

open Scc_exact

type t = Ivec.t array
(** The corners, counterclockwise, at least three; no three of them in one line. *)

val point : Z.t -> Z.t -> Z.t -> Ivec.t
(** [point x y w], for w > 0. *)

val place : Ivec.t -> Rat.t * Rat.t

val through : Ivec.t -> Ivec.t -> Ivec.t
(** The line from a point to another one. Primitive. *)

val sides : t -> Ivec.t array
(** The lines along its sides, from each corner to the next: it is to the left of all of them. *)

val cut : t -> Ivec.t -> t option * t option
(** What is to the left and what is to the right of a line. [None] is what has no area. *)

val split : t -> Ivec.t array -> (t * t list) option
(** What is to the left of all lines, and the rest in disjoint pieces. [None]: nothing that has an area is to the
    left of all. *)

val contains : t -> Ivec.t -> bool
(** A point of it, or of its sides. *)

val inside : t -> Ivec.t -> bool
(** A point of it, and not of its sides. *)

val area2 : t -> Rat.t
(** Twice the area. *)

val middle : t -> Ivec.t
(** The mean of the corners: a point inside. *)

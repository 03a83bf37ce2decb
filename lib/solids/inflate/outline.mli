(** The outline of a shape as polygons, and its simplification to fewer corners. Places as in {!Front}. *)

type place = int * int

(** A closed line without repetition, counter-clockwise on the screen around the shape, and clockwise around a
    hole. *)
type loop = place array

val trace : Silhouette.t -> loop list
(** The outlines of a shape, simple and pairwise disjoint: the outer one first, then one for each hole. They
    have a corner half-way between each pixel of the shape and each of its neighbours outside. *)

val corners : loop list -> int
(** The number of corners of all loops together. *)

type simplified = {
  loops : loop list;  (** corners are some of those before *)
  off : int;  (** a bound on the distance of the two outlines anywhere, in 1/256 of a pixel *)
}

val simplify : Silhouette.t -> most:int -> loop list -> simplified
(** [simplify shape ~most loops] removes corners, the least important ones first, until [most] are left in all.
    Loops never touch each other or themselves, so there may be more than [most]. Corners without any effect
    are always removed. *)

(** The outline of a shape as polygons, and the same with fewer corners. Places as in {!Front}. *)

type place = int * int

(** A closed line without repetition, counter-clockwise on the screen around the shape, and clockwise around a
    hole. *)
type loop = place array

val trace : Silhouette.t -> loop list
(** Simple and pairwise disjoint: the outer one, and one for each hole. They have a corner half-way between each
    pixel of the shape and each of its neighbours outside. The outer one comes first. *)

val corners : loop list -> int
(** In all. *)

type simplified = {
  loops : loop list;  (** corners are some of those before *)
  off : int;  (** the two outlines are nowhere farther apart, in 1/256 of a pixel *)
}

val simplify : Silhouette.t -> most:int -> loop list -> simplified
(** Takes away corners, first those that matter least, until [most] are left in all, but never so that loops would
    touch each other or themselves: there may be more than [most]. Corners that do not matter at all go in any
    case. *)

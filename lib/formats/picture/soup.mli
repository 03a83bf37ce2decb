(** Any faces, as a {!Camera} sees them, from both sides: of sets that need bound no solid. A face that is no
    convex polygon of a plane is divided into triangles, as it looks in the picture; where it crosses itself
    there may be gaps. *)

open Scc_exact

type t = {
  points : View.points;
  view : View.t;
  (** pieces of faces, whose [face] is the face; [body] is 0 for an outer side, 1 for an inner one *)
}

val make : Camera.t -> origin:Ivec.t -> Vec.t array -> int array array -> t
(** Numbers that are out of range are left out of faces. *)

val inner : View.face -> bool

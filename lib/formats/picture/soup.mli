(** Any faces in the view of a {!Camera}, from both sides; they need not bound a solid. A face that is no convex
    polygon of a plane is divided into triangles in the plane of the picture. There may be gaps where it crosses
    itself, and it is left out if it has more than 200 corners. *)

open Scc_exact

(** The view of a set of faces. *)
type t = {
  points : View.points;
  view : View.t;
  (** pieces of faces, whose [face] is the face; [body] is 0 for an outer side, 1 for an inner one *)
}

val make : Camera.t -> origin:Ivec.t -> Vec.t array -> int array array -> t
(** [make camera ~origin vertices faces] is the view of the faces, which are indices of vertices. Indices out of
    range are left out of faces. *)

val inner : View.face -> bool
(** [inner f] is true if the piece shows the inner side of its face. *)

(** Convex solids cut by planes. *)

open Scc_exact
open Scc_geometry

(** What a face of a piece is part of. *)
type face_of =
  | Face of int  (** a face of the whole *)
  | Seam of int  (** the plane of this number *)

type plane = { normal : Vec.t; offset : Rat.t }  (** the points x with normal.x = offset *)

type piece = { faces : (face_of * Vec.t list) list }  (** corners counter-clockwise, seen from outside *)

val whole : Polyhedron.ifs -> piece

val is_cut : plane -> piece -> bool
(** The plane passes through its interior. *)

val cut : most:int -> plane list -> piece -> piece list option
(** Along all the planes that pass through it: the closures of what is left of the interior without them, which
    have disjoint interiors. Two of them that have a face in common have all of it in common. [None] for more
    than [most]. *)

val ifs : piece -> vertex:(int -> string) -> face:(face_of -> string) -> Polyhedron.ifs
(** With its corners numbered from 0, in the order of {!Vec.compare}. *)

val joints : piece array -> (int * int * int) list
(** Pairs of pieces with a seam in common, and its number: a spanning tree of all pieces. *)

val volume : piece -> Rat.t
val area : piece -> int -> Vec.t
(** Twice the area of the piece's part of that face of the whole, as a vector along the normal of the face:
    these add up over pieces as areas do. *)

(** Convex solids cut by planes. *)

open Scc_exact
open Scc_geometry

(** The origin of a face of a piece. *)
type face_of =
  | Face of int  (** a face of the whole *)
  | Seam of int  (** the plane of this number *)

type plane = { normal : Vec.t; offset : Rat.t }  (** the points x with normal.x = offset *)

type piece = { faces : (face_of * Vec.t list) list }  (** corners counter-clockwise, seen from outside *)

val whole : Polyhedron.ifs -> piece
(** The uncut solid as one piece. *)

val is_cut : plane -> piece -> bool
(** [is_cut plane p] is true if the plane passes through the interior of [p]. *)

val cut : most:int -> plane list -> piece -> piece list option
(** [cut ~most planes p] cuts [p] along all planes that pass through it. The pieces have disjoint interiors, and
    their union is [p]. Two pieces that share a part of a face share the whole face. It is [None] for more than
    [most] pieces. *)

val ifs : piece -> vertex:(int -> string) -> face:(face_of -> string) -> Polyhedron.ifs
(** The faces of a piece with names. Its corners are numbered from 0, in the order of {!Scc_exact.Vec.compare}. *)

val joints : piece array -> (int * int * int) list
(** Pairs of pieces with a common seam, and the number of its plane. They are a spanning tree of all pieces. *)

val volume : piece -> Rat.t
(** The exact volume of a piece. *)

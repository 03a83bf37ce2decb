(** The outline of a set of the plane: its borders, lines and points. *)

open Scc_polyhedra

type border = {
  ends : Planar.point * Planar.point;  (** with the set to the left *)
  belongs : bool;  (** true if the points between the ends are in the set *)
}

type t = {
  polygons : Polyhedron.t list;  (** the pieces with an area *)
  borders : border list;
  (** the borders of the polygons where no other polygon is on the other side. Those in one line that meet are
      one. *)
  lines : (Planar.point * Planar.point) list;  (** pieces without area, where they are not at a polygon *)
  points : Planar.point list;  (** that are at no polygon and at no line *)
}

val make : Union.t -> t
(** The outline of a set whose pieces are disjoint and bounded. *)

val corners : t list -> Planar.point list
(** The ends of borders and lines of these sets, and their points; each once, in the order of
    {!Planar.compare}. *)

(** What of a set of the plane is drawn besides its inside. *)

open Scc_polyhedra

type border = {
  ends : Planar.point * Planar.point;  (** with the set to the left *)
  belongs : bool;  (** whether the points between the ends are in the set *)
}

type t = {
  polygons : Polyhedron.t list;  (** the pieces with an area *)
  borders : border list;
  (** of what has an area: where there is none of the set on the other side. Those in one line that meet are
      one. *)
  lines : (Planar.point * Planar.point) list;  (** what has no area, and is not at a polygon *)
  points : Planar.point list;  (** that are at no polygon and at no line *)
}

val make : Union.t -> t
(** Of disjoint, bounded pieces. *)

val corners : t list -> Planar.point list
(** Where borders and lines of these sets end, and their points; each once, in order. *)

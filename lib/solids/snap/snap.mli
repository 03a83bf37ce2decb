(** Exact solids near rounded ones. Coordinates in practice are rounded: the corners of a face with more than
    three of them are not quite in one plane. This module finds a convex closed polyhedron with the same
    vertices, faces and names within a distance. It is guessed in floats ({!Polish}) and placed exactly on a
    grid that is as coarse as possible ({!Order}, {!Placing}). It is checked exactly: by
    {!Scc_geometry.Polyhedron.of_ifs} and by the distances. *)

open Scc_exact
open Scc_geometry

type snapped = {
  set : Polyhedron.ifs;  (** of a convex closed polyhedron *)
  moved : Rat.t array;
  (** an upper bound on the distance that each vertex has moved, greater by less than two in ten bits
      ({!Scc_exact.Rat.sqrt_above}) *)
  turned_over : bool;  (** the faces were listed clockwise, all of them *)
  bits : int;  (** of the longest coordinate *)
}

type refusal =
  | Not_a_surface of Polyhedron_fault.t list  (** faults that moving vertices cannot repair *)
  | Not_of_a_solid
  (** the faces are those of no convex polyhedron, or folded: the mean of the vertices is not behind all
      faces *)
  | Too_far of { vertex : int; distance : Rat.t }
  (** the nearest such solid that was found moves this vertex by this distance *)
  | Not_found of Polyhedron_fault.t list
  (** the set found within the distance is no polyhedron, with these faults; there may be another one *)
  | Too_large

val snap : tolerance:Rat.t -> Polyhedron.ifs -> (snapped, refusal) result
(** [snap ~tolerance set] moves no vertex farther than the tolerance, which is positive. A convex closed
    polyhedron is unchanged. The set is not {!Scc_geometry.Polyhedron.too_fine}. *)

val explain : Polyhedron.ifs -> tolerance:Rat.t -> refusal -> string * string option
(** A sentence for readers, without the final full stop, and advice. *)

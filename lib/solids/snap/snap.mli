(** Exact solids near rounded ones. What people have is rounded: the corners of a face with more than three of
    them do not lie in one plane, by a little. Here is a convex closed polyhedron with the same vertices, faces and
    names within a distance. It is guessed in floats ({!Polish}), placed exactly on a grid that is as coarse as may
    be ({!Order}, {!Place}), and judged exactly: by {!Scc_geometry.Polyhedron.of_ifs} and by the distances. *)

open Scc_exact
open Scc_geometry

type snapped = {
  set : Polyhedron.ifs;  (** of a convex closed polyhedron *)
  moved : Rat.t array;
  (** how far each vertex is from where it was: at least, and more by less than two in ten bits
      ({!Rat.sqrt_above}) *)
  turned_over : bool;  (** the faces were listed clockwise, all of them *)
  bits : int;  (** of the longest coordinate *)
}

type refusal =
  | Not_a_surface of Polyhedron_fault.t list  (** what moving vertices does not mend *)
  | Not_of_a_solid
  (** with the faces of no convex polyhedron, or folded: the mean of the vertices is not behind all faces *)
  | Too_far of { vertex : int; distance : Rat.t }
  (** the nearest such solid, as far as is known, has this vertex so far from where it is *)
  | Not_found of Polyhedron_fault.t list
  (** what is found within the distance is none, for these reasons: perhaps there is one *)
  | Too_large

val snap : tolerance:Rat.t -> Polyhedron.ifs -> (snapped, refusal) result
(** No vertex moves farther than the tolerance (positive). A convex closed polyhedron stays as it is. The set is
    not {!Polyhedron.too_fine}. *)

val explain : Polyhedron.ifs -> tolerance:Rat.t -> refusal -> string * string option
(** A sentence for a person, without the final full stop, and what to do about it. *)

(** Boxes, prisms and pyramids as indexed face sets: what their vertices and faces are called, and where they
    are, is told in specs/language.md. All lengths are positive, and there are at least three corners. *)

open Scc_exact

val on_circle : int -> int -> Rat.t * Rat.t
(** [on_circle n k], 0 <= k < n: a rational point of the unit circle, exactly, at an angle that differs from k/n
    of a full turn by less than 2^-10 radians, and not at all for quarters of a turn. *)

val box : Rat.t -> Rat.t -> Rat.t -> Polyhedron.ifs

val prism : int -> Rat.t -> Rat.t -> Polyhedron.ifs
(** Corners, radius and height, as of the next two. *)

val antiprism : int -> Rat.t -> Rat.t -> Polyhedron.ifs
val pyramid : int -> Rat.t -> Rat.t -> Polyhedron.ifs

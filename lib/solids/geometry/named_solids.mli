(** Boxes, prisms and pyramids as indexed face sets. The names and places of their vertices and faces are
    defined in specs/language.md. All lengths are positive, and there are at least three corners. *)

open Scc_exact

val on_circle : int -> int -> Rat.t * Rat.t
(** [on_circle n k], for 0 <= k < n, is a rational point of the unit circle near k/n of a full turn. The point
    is exactly on the circle. Its angle is off by less than 2^-10 radians, and exact for quarters of a turn. *)

val box : Rat.t -> Rat.t -> Rat.t -> Polyhedron.ifs
(** [box a b c] is the box with edges of these lengths along x, y and z, centred at the origin. *)

val prism : int -> Rat.t -> Rat.t -> Polyhedron.ifs
(** [prism n r h] is the prism of height h along z over n corners on a circle of radius r. It is centred at the
    origin. *)

val antiprism : int -> Rat.t -> Rat.t -> Polyhedron.ifs
(** [antiprism n r h] is a prism of height h whose top is turned by half a corner, with 2n triangles as sides.
    Its n corners of top and bottom are on circles of radius r. *)

val pyramid : int -> Rat.t -> Rat.t -> Polyhedron.ifs
(** [pyramid n r h] has n corners on a circle of radius r at z = -h/4, and its apex at z = 3h/4. *)

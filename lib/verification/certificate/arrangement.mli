(** Cuts of a set of states into pieces, by brute force, along every plane that could matter. All inputs of the
    discrete rules are the same throughout a piece. *)

open Scc_polyhedra
open Scc_state_sets

val by_signs : Linear.t list -> Polyhedron.t list -> Polyhedron.t list
(** [by_signs forms regions] cuts the regions by the signs of all forms: where each is 0, positive or negative.
    No piece is empty. *)

val cells : Zone_parts.context -> Zone.t -> Polyhedron.t list
(** Regions whose union is the zone. Throughout each of them the same parts touch, by the same planes, and the
    same features of them touch. *)

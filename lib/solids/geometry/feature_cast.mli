(** When a feature that moves in a straight line first meets another (reading I-33): exact. Features are closed: a
    vertex, an edge with its ends, a face with its border, given by their corners. *)

open Scc_exact

val first_meeting : Vec.t list -> Vec.t list -> Vec.t -> Rat.t option
(** [first_meeting p q w]: the least t >= 0 at which p and q + t w have a point in common. *)

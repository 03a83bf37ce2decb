(** The exact first time at which a feature that moves in a straight line meets another (reading I-33).
    Features are closed: a vertex, an edge with its ends, a face with its border. They are given by their
    corners. *)

open Scc_exact

val first_meeting : Vec.t list -> Vec.t list -> Vec.t -> Rat.t option
(** [first_meeting p q w] is the least t >= 0 at which [p] and [q] + t [w] have a common point; [None] if there
    is none. *)

(** The spaces that two convex solids sweep as they are displaced. *)

open Scc_exact

val meet : Obstacle.t -> Vec.t -> Vec.t -> Vec.t -> bool
(** [meet o r v u] is true if the interiors of two swept spaces meet. The first solid of [o] sweeps all places from
    here to its displacement by [v], the second one those from the offset [r] on to a displacement by [u]. *)

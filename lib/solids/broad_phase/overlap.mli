(** Pairs of placed solids that interpenetrate (rule Contact), and where they do. *)

open Scc_exact
open Scc_geometry

(** A solid in the world. *)
type placed = {
  body : int;  (** solids of one body are not compared *)
  solid : Solid.t;
  position : Vec.t;  (** of its reference point, in the world *)
}

val pairs : ?limit:int -> Obstacle_cache.t -> placed array -> (int * int) list
(** The interpenetrating pairs of different bodies, as indices i < j in lexicographic order. Of solids that are
    equal and at one place, each is paired with the first only. With [limit], the list has at most so many
    pairs, and is empty iff no pair interpenetrates. It need not have the least pairs then, but is the same
    from run to run. *)

val common_point : placed -> placed -> Vec.t option
(** A point in the world strictly inside both; [None] iff their interiors do not meet. *)

(** Which of many placed solids interpenetrate (rule Contact), and where. *)

open Scc_exact
open Scc_geometry

(** A solid in the world. *)
type placed = {
  body : int;  (** solids of one body are not compared *)
  solid : Solid.t;
  position : Vec.t;  (** of its reference point *)
}

val pairs : ?limit:int -> Obstacle_cache.t -> placed array -> (int * int) list
(** The interpenetrating pairs of different bodies, as indices i < j in lexicographic order. Of solids that
    are equal and at one place, each is paired with the first only. With [limit], at most so many pairs, and
    none iff there is none: not always the least ones, but the same from run to run. *)

val common_point : placed -> placed -> Vec.t option
(** A point in the world strictly inside both; [None] iff their interiors do not meet. *)

(** The way of each leaf over a run, told by keys: between two keys in a row it goes in a straight line, or, if it
    turns, by no more than a tenth of a radian, so that a player that goes on evenly from the one to the other is
    right at every key, and near in between. *)

open Scc_exact
open Scc_motion

type key = {
  time : Rat.t;
  at : Vec.t;  (** of the reference point *)
  turned : Quaternion.t;
}

type t = {
  keys : key array;
  (** in order of time, at least one, the first at 0. After the last, and where nothing is told, it stays. Where a
      leaf begins or ceases to move, turns about or is met, there is one. *)
  gone : Rat.t option;  (** when it is absorbed *)
}

val of_course : Course.t -> t array
(** For each leaf of the model. *)

val of_ways : Ways.t -> t array
(** The same of such a run. *)

val turns : t -> bool
(** It is not always turned as it is at first. *)

val moves : t -> bool

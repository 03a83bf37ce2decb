(** The way of each leaf over a run, as keys. Between two keys in a row a leaf moves in a straight line, or
    turns by at most a tenth of a radian. So a player that interpolates evenly is exact at every key and near in
    between. *)

open Scc_exact
open Scc_motion

(** The pose of a leaf at an instant, in the world. *)
type key = {
  time : Rat.t;
  at : Vec.t;  (** of the reference point *)
  turned : Quaternion.t;
}

(** The way of a leaf. *)
type t = {
  keys : key array;
  (** in order of time, at least one, the first at 0. A leaf rests after the last one, and between two of one pose.
      There is a key wherever a leaf begins or ceases to move, changes its direction or is met. *)
  gone : Rat.t option;  (** the time at which it is absorbed *)
}

val of_course : Course.t -> t array
(** The track of each leaf of the model over a run with all its states. *)

val of_ways : Ways.t -> t array
(** The track of each leaf of the model over a run given by its changes. *)

val turns : t -> bool
(** [turns t] is true if the orientation changes along the track. *)

val moves : t -> bool
(** [moves t] is true if the track has more than one key. *)

(** The data sets of [geometry/] (its README says what they hold), and solids in both representations. *)

open Scc_exact
open Scc_geometry

val solid : id:int -> Scc_naive.Naive.solid -> Mat.t -> Solid.t
(** The library's solid for the image of a plain one under a linear map. *)

val shape : string -> Scc_naive.Naive.solid
(** Reads a file of the first kind. *)

type case = {
  near : Vec.t;  (** t *)
  far : Vec.t;
  velocity : Vec.t;
  turn : Mat.t;  (** of B *)
}

val pairs : string -> case array
(** Reads a file of pairs. *)

val is_kissing : string -> bool
(** Whether it is a file of kissing cubes rather than of pairs. *)

val kissing : string -> (Mat.t * Vec.t) array
(** The turn of both cubes, and the displacement of the second. *)

val lines : string -> string array

val touch_word : (Rat.t option * Rat.t option) option -> string
(** The second half of a line of an answer file, from the interval of all times at which two bodies meet. *)

val answer : Obstacle.t -> Vec.t -> Vec.t -> string
(** What {!Obstacle} says of a cast, in the words of an answer file. *)

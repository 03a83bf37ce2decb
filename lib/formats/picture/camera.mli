(** The viewpoint of a picture: an infinitely far point in a direction of integers, so there is no perspective.
    Its axes are orthogonal, to the right, up and towards the viewer. They are integer vectors of any length:
    along each axis, lengths are multiplied by the length of the axis. *)

open Scc_exact

(** The three axes, in the world. *)
type t = private { right : Ivec.t; up : Ivec.t; near : Ivec.t }

val make : ?up:Vec.t -> Vec.t -> t
(** [make d] views the scene from the side to which [d], which is not zero, points. [up] (default: the y axis)
    is upwards in the picture. If [up] is along [d], the direction against the z axis or the y axis replaces
    it. *)

val turn : t -> Ivec.t -> Ivec.t
(** The components of a vector along the axes, each times the length of its axis. *)

val flat : t -> Vec.t -> Rat.t * Rat.t
(** The components of a point to the right and up, each times the length of its axis. *)

val lengths : t -> Rat.t * Rat.t
(** The lengths of the axes to the right and up, to forty bits. *)

(** The viewpoint of a picture: an infinitely far point in a direction of integers, or an eye, which sees in
    perspective. Its axes are orthogonal, to the right, up and towards the viewer. They are integer vectors of
    any length: along each axis, lengths are multiplied by the length of the axis. *)

open Scc_exact

(** The three axes, in the world. *)
type t = private { right : Ivec.t; up : Ivec.t; near : Ivec.t; eye : eye option  (** [None]: infinitely far *) }

(** A viewpoint at a place. *)
and eye = {
  at : Vec.t;
  least : Rat.t;  (** positive: what is less far in front of the eye is cut off *)
}

val make : ?up:Vec.t -> Vec.t -> t
(** [make d] views the scene from the side to which [d], which is not zero, points. [up] (default: the y axis)
    is upwards in the picture. If [up] is along [d], the direction against the z axis or the y axis replaces
    it. *)

val with_eye : t -> eye -> t
(** [with_eye t eye] has the axes of [t], and sees from [eye] against the axis towards the viewer. *)

val in_front : t -> Z.t -> (Ivec.t -> Z.t) option
(** [in_front t over] returns for a point [p] of the world, as [p] / [over], a number that is negative if the
    point is cut off. It is a linear function of the point. [None] if nothing is cut off: the viewpoint is
    infinitely far. *)

val sees_back : t -> normal:Ivec.t -> Ivec.t -> Z.t -> bool
(** [sees_back t ~normal p over] is true if the plane through the point [p] / [over] with this outward normal
    shows its inner side. *)

val turn : t -> Ivec.t -> Ivec.t
(** The components of a vector along the axes, each times the length of its axis. *)

val flat : t -> Vec.t -> Rat.t * Rat.t
(** The components of a point to the right and up, each times the length of its axis. *)

val lengths : t -> Rat.t * Rat.t
(** The lengths of the axes to the right and up, to forty bits. *)

val length_near : t -> Rat.t
(** The length of the axis towards the viewer, to forty bits. *)

(** Where a picture is seen from: from very far away, in a direction of integers, without perspective. Its axes are
    orthogonal, to the right, up and towards whoever looks; they are integer vectors, and so not of length 1: along
    each of them lengths are multiplied by the length of the axis. *)

open Scc_exact

type t = private { right : Ivec.t; up : Ivec.t; near : Ivec.t }

val make : ?up:Vec.t -> Vec.t -> t
(** [make d] looks at things from the side to which [d] points; [d] is not zero. [up] (the y axis)
    is upwards in the picture; if it is along [d], the direction against the z axis, or the y axis. *)

val turn : t -> Ivec.t -> Ivec.t
(** The components of a vector along the axes, each times the length of its axis. *)

val flat : t -> Vec.t -> Rat.t * Rat.t
(** The first two of them, of a point. *)

val lengths : t -> Rat.t * Rat.t
(** Of the first two axes, to forty bits. *)

(** Exact numbers as floats, at the last moment, for formats that hold nothing better. Only operations that IEEE
    754 rounds correctly are used, so that every machine writes the same bytes. *)

open Scc_exact

exception Too_great
(** A number is too great for the floats of a format. *)

val text : float -> string
(** The shortest of the usual forms that reads back as the same float; never an infinity (a bug otherwise). *)

val of_rat : Rat.t -> float
(** The nearest one, and 0 rather than -0. Raises {!Too_great}, as what follows does. *)

val point : Vec.t -> float array

val single : float -> float
(** The nearest number of 32 bits. *)

val unit : Z.t array -> float array
(** The direction of integers that are not all zero, of length 1. *)

val atan2 : float -> float -> float
(** [atan2 y x], within some units of the last place. *)

val axis_angle : Quaternion.t -> float array
(** The axis, of length 1, and the angle from 0 to pi. *)

val euler : Quaternion.t -> float array
(** The angles x, y, z of the same rotation, done about the axes z, y, x of the world in this order. *)

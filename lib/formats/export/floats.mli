(** Exact numbers as floats, at the last moment, for formats that have nothing better. Only operations that IEEE
    754 rounds correctly are used, so every machine writes the same bytes. *)

open Scc_exact

exception Too_great
(** A number is too great for the floats of the format. *)

val text : float -> string
(** The shortest of the usual forms that reads back as the same float. A float that is not finite is a bug. *)

val of_rat : Rat.t -> float
(** The nearest float of 64 bits, and 0 rather than -0. Raises {!Too_great}; so do the functions below. *)

val point : Vec.t -> float array
(** The components of a vector, each as by {!of_rat}. *)

val single : float -> float
(** The nearest number of 32 bits. *)

val unit : Z.t array -> float array
(** The vector of length 1 in the direction of these integers, which are not all zero. *)

val axis_angle : Quaternion.t -> float array
(** The axis, of length 1, and the angle in radians, from 0 to pi. *)

val euler : Quaternion.t -> float array
(** The angles x, y, z in radians of the same rotation, done about the axes z, y, x of the world in this
    order. *)

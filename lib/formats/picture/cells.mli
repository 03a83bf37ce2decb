(** Which boxes of the plane may meet: a grid over all of them, in floats. *)

type box = { left : float; right : float; low : float; high : float }
(** Rounded outwards. *)

val below : float -> float
(** No greater than a number that {!Scc_exact.Rat.near_float} has rounded to this. *)

val above : float -> float

val around : Scc_exact.Ivec.t array -> box
(** Of points, as in {!Convex}. *)

val meet : box -> box -> bool

type t

val make : box array -> t

val near : t -> box -> int list
(** At least the numbers of all boxes that meet this one, in increasing order. *)

(** Boxes of the plane that may meet, found by a grid over all of them, in floats. *)

type box = { left : float; right : float; low : float; high : float }
(** Rounded outwards. *)

val below : float -> float
(** [below x] is at most each number that {!Scc_exact.Rat.near_float} rounds to [x]. *)

val above : float -> float
(** [above x] is at least each number that {!Scc_exact.Rat.near_float} rounds to [x]. *)

val around : Scc_exact.Ivec.t array -> box
(** A box that contains the points, which are as in {!Convex}. *)

val meet : box -> box -> bool
(** [meet a b] is true if the boxes have a point in common. *)

(** A grid over some boxes. *)
type t

val make : box array -> t
(** The grid over these boxes, with about as many cells as boxes, at most 10 000. *)

val near : t -> box -> int list
(** The numbers of all boxes of the grid that meet this one, in increasing order. *)

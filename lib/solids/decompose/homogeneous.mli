(** Points of space as four integers, (x/w, y/w, z/w), with w > 0 and without a common divisor. So the numbers
    of points where planes intersect are as short as possible. *)

open Scc_exact

type near = private { nx : float; ny : float; nz : float }
(** The coordinates in floats, each with a relative error of at most 3 * 2^-53. All or some are NaNs where a number
    is 2^1000 or greater. They are for filters alone. *)

type t = private { x : Z.t; y : Z.t; z : Z.t; w : Z.t; near : near }

val near_integer : Z.t -> float
(** [near_integer n] is a float with a relative error of at most 2^-53, or a NaN if [n] is 2^1000 or greater in
    magnitude. *)

val of_vec : Vec.t -> t
(** The point with these rational coordinates. *)

val to_vec : t -> Vec.t
(** The rational coordinates of a point. *)

val equal : t -> t -> bool
(** [equal p q] is true if both are the same point. *)

val compare : t -> t -> int
(** A total order: that of the numbers (x, y, z, w), not that of coordinates. *)

val hash : t -> int
(** A hash that is compatible with {!equal}. *)

val crossing : t -> Z.t -> t -> Z.t -> t
(** [crossing p (Plane.height s p) q (Plane.height s q)] is the point where the segment from [p] to [q] crosses
    the plane [s]. The two points are strictly on different sides of it. *)

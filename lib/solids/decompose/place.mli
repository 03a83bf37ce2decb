(** Points of space as four integers, (x/w, y/w, z/w) with w > 0 and no common divisor: what planes cut out of
    planes stays as short as it can be. *)

open Scc_exact

type t = private { x : Z.t; y : Z.t; z : Z.t; w : Z.t }

val of_vec : Vec.t -> t
val to_vec : t -> Vec.t
val equal : t -> t -> bool

val compare : t -> t -> int
(** Some order; not that of coordinates. *)

val hash : t -> int

val crossing : t -> Z.t -> t -> Z.t -> t
(** [crossing p (Plane.height s p) q (Plane.height s q)], of points on different sides of the plane s: where the
    segment between them meets it. *)

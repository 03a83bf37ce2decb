(** The distance of two convex sets, each the hull of some points (at least one): exact, without any tolerance. *)

open Scc_exact

val vector : Vec.t array -> Vec.t array -> Vec.t
(** [vector a b] is the one vector of least length from a point of the hull of [a] to a point of the hull of
    [b]. It is zero iff the closed sets meet. It is the vector x with x.(q - p) >= x.x for all p of [a] and q
    of [b]. *)

val distance2 : Vec.t array -> Vec.t array -> Rat.t
(** The squared distance of the hulls of both sets. *)

val vector_over : Z.t -> Ivec.t array -> Ivec.t array -> Vec.t
(** [vector_over denominator a b] is {!vector} for integer points over one positive denominator. *)

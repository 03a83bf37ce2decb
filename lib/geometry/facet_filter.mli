(** The facets of an obstacle seen through floats: guesses, and comparisons that are either certain or left
    open. Nothing here decides a case that is close; the caller does, over the integers. *)

open Scc_exact

type t

val make : Minkowski.facet array -> t

(** A line through the obstacle, (p + t v)/q over the denominator of the facets. *)
type line

val line : Ivec.t -> Ivec.t -> Z.t -> line
(** [line p v q]. *)

val guess : t -> line -> int * int
(** The facet whose plane the line seems to enter last, and the one it seems to leave first; -1 for none. *)

val side : t -> line -> float -> int -> int
(** [side f line t k]: 1 when at time [t] >= 0 the line is certainly strictly inside the plane of facet [k], -1
    when it is certainly strictly outside, 0 when floats cannot tell. [t] is the quotient of the floats of
    two integers. *)

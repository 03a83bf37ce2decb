(** The same answers as {!Naive}, over the integers and with the axes of a pair of solids made once: quick enough
    for a million casts. It looks at every separating axis, both ways, for every query. It shares with the
    library only the types of vectors and rationals. *)

open Scc_exact

type t

val make : Naive.solid -> Naive.solid -> t
(** The first solid at rest where it stands; the second is displaced by the offset [r] of each query. *)

val axes : t -> int
(** How many directions each query looks at. *)

val reduce : t -> t
(** Only the axes that carry a facet of the Minkowski difference: the same answers, sooner. *)

val relation : t -> Vec.t -> Naive.relation
val first_time_of_contact : t -> Vec.t -> Vec.t -> Naive.cast
val meeting : t -> Vec.t -> Vec.t -> (Rat.t option * Rat.t option) option

val tight : t -> Vec.t -> Ivec.t list
(** The primitive directions, from the first solid to the second, of all axes along which the two touch at the
    offset and that carry a facet of the difference; in order. *)

val approaching : t -> Vec.t -> Vec.t -> bool
(** Of touching solids: whether the velocity leads inwards along every axis along which they touch. *)

val facets : t -> Ivec.t array
(** The primitive directions of all axes that carry a facet, in order. *)

val support : t -> Ivec.t -> int list * int list
(** The corners of the first solid that are highest in a direction, and those of the second that are lowest;
    increasing. *)

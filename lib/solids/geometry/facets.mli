(** The obstacle of two solids by all of its facets: slow to make, and sure. {!Obstacle} turns to it for what it
    cannot prove with less. *)

open Scc_exact

type t

val make : Solid.t -> Solid.t -> t
val facets : t -> Minkowski.facet array

(** As in {!Obstacle}, for an offset r and a velocity w. *)

type relation = Apart | Touching | Interpenetrating

val relation : t -> Vec.t -> relation
val separating : t -> Vec.t -> Ivec.t list

type cast = Never | Inside | At of Rat.t

val first_time_of_contact : t -> Vec.t -> Vec.t -> cast
val meeting : t -> Vec.t -> Vec.t -> (Rat.t option * Rat.t option) option

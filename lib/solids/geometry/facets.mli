(** The obstacle of two solids by all of its facets. It is slow to make; its answers need no guess. {!Obstacle}
    uses it where a quicker proof fails. *)

open Scc_exact

type t

val make : Solid.t -> Solid.t -> t
(** [make a b] is the obstacle A - B. The work is the number of edges of A times that of B. *)

val facets : t -> Minkowski.facet array
(** The facets of the obstacle, as in {!Minkowski.facets}. *)

(** The relation of two closed bodies, as in {!Obstacle.val-relation}. *)

type relation = Apart | Touching | Interpenetrating

val relation : t -> Vec.t -> relation
(** [relation o r] is the relation of the bodies at offset [r]: the sign of r against all facets. *)

val separating : t -> Vec.t -> Ivec.t list
(** [separating o r], for touching bodies (a bug otherwise), are the normals of the facets that contain [r]. *)

type cast = Never | Inside | At of Rat.t

val first_time_of_contact : t -> Vec.t -> Vec.t -> cast
(** [first_time_of_contact o r w] is the answer of {!Obstacle.first_time_of_contact} for offset [r] and
    relative velocity [w]. *)

val meeting : t -> Vec.t -> Vec.t -> (Rat.t option * Rat.t option) option
(** [meeting o r w] is the closed interval of times at which the closed bodies meet, as in {!Obstacle.meeting}.
*)

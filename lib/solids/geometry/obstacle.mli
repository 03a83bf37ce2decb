(** The Minkowski obstacle of two convex solids A and B: the set of offsets r (from the reference point of
    A to that of B) at which A and B meet. As orientations do not change in the translational calculus, it
    is made once for each pair of solids, and every query is then a look at its facets. *)

open Scc_exact

(** Offsets r with [normal . r >= num/den] separate the interiors of A and B, and the plane
    [normal . r = num/den] carries a facet of the obstacle. *)
type facet = Minkowski.facet = {
  normal : Ivec.t;  (** primitive, pointing from A to B *)
  num : Z.t;
  den : Z.t;  (** positive; the same for all facets of an obstacle *)
}

type memory

type t = private {
  a : Solid.t;
  b : Solid.t;
  all : Facets.t Scc_base.Later.t;  (** all facets, made when a query cannot do without them *)
  guess : Portal.guess;
  memory : memory;  (** what proved the last answers, where the next proof is sought first *)
}

val make : ?guess:Portal.guess -> Solid.t -> Solid.t -> t
(** Answers do not depend on [guess]: tests make it guess at random. *)

val facets : t -> facet array
(** Exactly the facets of the obstacle, each once. *)

(** Rule Contact: closed sets, interiors. *)
type relation = Facets.relation = Apart | Touching | Interpenetrating

val relation : t -> Vec.t -> relation

val separating : t -> Vec.t -> Ivec.t list
(** [separating o r] for touching bodies (a bug otherwise): the extreme directions n, from A to B, that
    separate them (the normals of the facets that hold r), primitive. Not empty. *)

val approaching : t -> Vec.t -> Vec.t -> bool
(** Rule Approach. [approaching o r w]: the bodies, touching at offset [r], would interpenetrate after
    every small delay when [w] is the velocity of B less that of A. *)

(** When a body moving in a straight line meets another. *)
type cast = Facets.cast =
  | Never
  | Inside  (** they interpenetrate at time 0 already *)
  | At of Rat.t  (** the first t >= 0 at which they collide: the interiors meet right after it *)

val first_time_of_contact : t -> Vec.t -> Vec.t -> cast
(** Rule Ftoc for two bodies. [first_time_of_contact o r w]: offset [r] at time 0, relative velocity [w].
    A graze is no collision. [At 0] iff the bodies touch and approach at [r]. *)

val meeting : t -> Vec.t -> Vec.t -> (Rat.t option * Rat.t option) option
(** [meeting o r w] is the closed interval of real times (also negative) at which the closed bodies meet;
    a bound is [None] when it is infinite (only for w = 0). *)

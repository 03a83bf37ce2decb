(** The Minkowski obstacle of two convex solids A and B: the set of offsets r at which A and B meet. The offset
    leads from the reference point of A to that of B. Orientations do not change in the translational calculus,
    so an obstacle is made once for each pair of solids. *)

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
  all : Facets.t Scc_base.Later.t;  (** all facets, made when a query needs them *)
  guess : Portal.guess;
  memory : memory;  (** the proofs of the last answers, which are tried first for the next one *)
}

val make : ?guess:Portal.guess -> Solid.t -> Solid.t -> t
(** [make a b] is the obstacle A - B. Answers do not depend on [guess]: tests use random guesses. *)

val facets : t -> facet array
(** Exactly the facets of the obstacle, each once. *)

(** Rule Contact: [Apart] if the closed bodies are disjoint, [Interpenetrating] if their interiors meet, else
    [Touching]. *)
type relation = Facets.relation = Apart | Touching | Interpenetrating

val relation : t -> Vec.t -> relation
(** [relation o r] is the relation of the bodies at offset [r] (rule Contact). *)

val separating : t -> Vec.t -> Ivec.t list
(** [separating o r] are the extreme directions n, from A to B, that separate touching bodies (a bug
    otherwise). They are the primitive normals of the facets that contain [r]. Not empty. *)

val approaching : t -> Vec.t -> Vec.t -> bool
(** Rule Approach. [approaching o r w] is true if the bodies, touching at offset [r], would interpenetrate
    after every small delay. Here [w] is the velocity of B less that of A. *)

(** The first collision of a body that moves in a straight line with another. *)
type cast = Facets.cast =
  | Never
  | Inside  (** they interpenetrate at time 0 already *)
  | At of Rat.t  (** the first t >= 0 at which they collide: the interiors meet right after it *)

val first_time_of_contact : t -> Vec.t -> Vec.t -> cast
(** Rule Ftoc for two bodies. [first_time_of_contact o r w] is their first collision with offset [r] at time 0
    and relative velocity [w]. A graze is no collision. The answer is [At 0] iff the bodies touch and approach
    at [r]. *)

val meeting : t -> Vec.t -> Vec.t -> (Rat.t option * Rat.t option) option
(** [meeting o r w] is the closed interval of real times, also negative, at which the closed bodies meet. A
    bound is [None] if it is infinite (only for [w] = 0). [None] if they never meet. *)

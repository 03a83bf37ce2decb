(** The elastic response of two rigid bodies in translation (rule Response, reading I-13). *)

open Scc_exact

(** A touching pair of parts, one of each body. *)
type touching = {
  obstacle : Obstacle.t;
  offset : Vec.t;  (** from the part of the first to that of the second *)
}

val exposed : Ivec.t list -> Ivec.t list list -> Ivec.t list
(** Reading I-13. [exposed own others] are those directions of [own] whose facets are not covered by other
    pairs. The list [own] has the extreme directions that separate a pair of parts; [others] has a list of
    directions for each other pair. A pair that interpenetrates has no directions, and covers all facets. *)

val with_others : 'a list -> ('a * 'a list) list
(** Each element with the list of all others. *)

val directions : touching list -> Vec.t -> Vec.t list
(** [directions touching w] are the directions, from the first body to the second, that span the cone of the
    collision. The list has all touching pairs of parts of the two bodies; [w] is the velocity of the second
    less that of the first. The directions are the extreme separating directions of the approaching pairs, less
    those whose facet is covered by other pairs, approaching or not. If every one is covered, all are kept. The
    list is empty if no pair approaches. *)

val bounce : touching list -> Vec.t -> Vec.t
(** [bounce touching w] is the relative velocity after the collision: w + 2 proj(-w) on the cone of
    {!directions}. *)

(** The elastic response of two rigid bodies in translation (rule Response, reading I-13). *)

open Scc_exact

(** A touching pair of parts, one of each body. *)
type touching = {
  obstacle : Obstacle.t;
  offset : Vec.t;  (** from the part of the first to that of the second *)
}

val exposed : Ivec.t list -> Ivec.t list list -> Ivec.t list
(** Reading I-13. [exposed own others]: of the extreme directions [own] that separate a pair of parts, those whose
    facets are not covered by the pairs that the [others] are the directions of, one list for each. A pair that
    interpenetrates has none, and covers all. *)

val with_others : 'a list -> ('a * 'a list) list
(** Each element with all the others. *)

val directions : touching list -> Vec.t -> Vec.t list
(** [directions touching w]: the directions (from the first body to the second) that span the cone of the
    collision, given all touching pairs of parts of the two bodies and the velocity [w] of the second less
    that of the first: the extreme separating directions of the approaching pairs, less those whose facet
    is covered by other pairs, be they approaching or not (all of them are kept when every one is
    covered). Empty when no pair approaches. *)

val bounce : touching list -> Vec.t -> Vec.t
(** The relative velocity after the collision: w + 2 proj(-w) on the cone above. *)

(** The Minkowski difference A - B of two convex solids, by its facets. *)

open Scc_exact

(** The plane [normal . r = num/den] carries a facet, and the difference lies where [normal . r <= num/den]. *)
type facet = {
  normal : Ivec.t;  (** primitive, outward *)
  num : Z.t;
  den : Z.t;  (** positive; the same for all facets *)
}

val facets : Solid.t -> Solid.t -> facet array
(** Exactly the facets of A - B, each once. Their order depends only on the solids. The work is the number of
    edges of A times that of B. *)

(** Exact non-negative least squares, by the active-set method of Lawson and Hanson, which ends after
    finitely many steps in exact arithmetic. *)

val solve : gram:Rat.t array array -> target:Rat.t array -> Rat.t array
(** [solve ~gram ~target] is an x >= 0 that minimises x.(gram x)/2 - x.target, for a symmetric positive
    semi-definite [gram] = G^T G with [target] = G^T b. *)

val project_cone : Vec.t list -> Vec.t -> Vec.t
(** The point of the cone spanned by the vectors that is nearest to a point. *)

val nearest_in_cone : most:(Vec.t -> Vec.t) -> Vec.t -> Vec.t
(** The same, of a cone that is spanned by finitely many vectors of which nobody needs a list: [most v] is one of
    them that is farthest along v. *)

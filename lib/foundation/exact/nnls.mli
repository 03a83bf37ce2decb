(** Exact non-negative least squares, by the active-set method of Lawson and Hanson, which ends after
    finitely many steps in exact arithmetic. *)

val solve : gram:Rat.t array array -> target:Rat.t array -> Rat.t array
(** [solve ~gram ~target] is an x >= 0 that minimises x.(gram x)/2 - x.target, for a symmetric positive
    semi-definite [gram] = G^T G with [target] = G^T b. *)

val project_cone : Vec.t list -> Vec.t -> Vec.t
(** [project_cone vectors point] is the point nearest to [point] in the cone that the vectors span. *)

val nearest_in_cone : most:(Vec.t -> Vec.t) -> Vec.t -> Vec.t
(** [nearest_in_cone ~most point] is the point nearest to [point] in a cone that finitely many vectors span,
    without a list of them: [most v] is one of the vectors whose product with [v] is greatest. *)

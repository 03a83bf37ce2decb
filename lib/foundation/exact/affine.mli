(** Affine maps of space: x -> linear x + translation (the 4 x 4 matrices of Definition 4.4 with last row
    0 0 0 1). *)

type t = { linear : Mat.t; translation : Vec.t }

val identity : t
val translate : Vec.t -> t
val of_linear : Mat.t -> t
val apply : t -> Vec.t -> Vec.t

val compose : t -> t -> t
(** [compose f g] is x -> f (g x). *)

val equal : t -> t -> bool

(** Affine maps of space: x -> linear x + translation (the 4 x 4 matrices of Definition 4.4 with last row
    0 0 0 1). *)

type t = { linear : Mat.t; translation : Vec.t }

val of_linear : Mat.t -> t
(** [of_linear m] is x -> m x. *)

val identity : t
(** The map that keeps every point. *)

val apply : t -> Vec.t -> Vec.t
(** [apply f x] is the image of the point [x], translation included. *)

val compose : t -> t -> t
(** [compose f g] is x -> f (g x). *)

val mirrors : t -> bool
(** [mirrors f] is true if the determinant is negative: counter-clockwise becomes clockwise. *)

val too_long : t -> bool
(** [too_long f] is true if some number has more than 4 000 bits: numbers grow with each composition. *)

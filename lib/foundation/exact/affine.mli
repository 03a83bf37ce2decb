(** Affine maps of space: x -> linear x + translation (the 4 x 4 matrices of Definition 4.4 with last row
    0 0 0 1). *)

type t = { linear : Mat.t; translation : Vec.t }

val translate : Vec.t -> t
(** [translate v] is x -> x + v. *)

val of_linear : Mat.t -> t
(** [of_linear m] is x -> m x. *)

val apply : t -> Vec.t -> Vec.t
(** [apply f x] is the image of the point [x], translation included. *)

val compose : t -> t -> t
(** [compose f g] is x -> f (g x). *)

val equal : t -> t -> bool
(** [equal f g] is true if linear part and translation are equal. *)

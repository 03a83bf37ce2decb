(** Affine maps that place the parts of a file: x goes to linear x + shift. *)

open Scc_exact

type t = { linear : Mat.t; shift : Vec.t }

val here : t
(** The identity. *)

val move : t -> Vec.t -> Vec.t
(** [move p x] is the image of the point [x]. *)

val inside : t -> t -> t
(** [inside outer inner] is the map that applies [inner], then [outer]. *)

val too_long : t -> bool
(** [too_long p] is true if some number has more than 4 000 bits: numbers grow with each composition. *)

val mirrors : t -> bool
(** [mirrors p] is true if the determinant is negative: counter-clockwise becomes clockwise. *)

(** Where parts of a file stand: x goes to linear x + shift. *)

open Scc_exact

type t = { linear : Mat.t; shift : Vec.t }

val here : t
val move : t -> Vec.t -> Vec.t

val inside : t -> t -> t
(** [inside outer inner]: the inner place first. *)

val too_long : t -> bool
(** Some number has more than 4 000 bits: numbers grow with each place that is inside of another. *)

val mirrors : t -> bool
(** Counter-clockwise becomes clockwise. *)

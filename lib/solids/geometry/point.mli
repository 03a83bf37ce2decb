(** A point of the obstacle A - B of two solids, by the numbers of the vertices of A and of B that make it. *)

type t [@@immediate]

val make : of_a:int -> of_b:int -> t
val of_a : t -> int
val of_b : t -> int
val equal : t -> t -> bool

val none : t
(** Made by no vertices. *)

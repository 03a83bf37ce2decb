(** A point of the obstacle A - B of two solids, by the numbers of the vertices of A and of B that make it. *)

type t [@@immediate]

val make : of_a:int -> of_b:int -> t
(** The point a - b for vertex [of_a] of A and vertex [of_b] of B, both below 2^31. *)

val of_a : t -> int
(** The number of the vertex of A. *)

val of_b : t -> int
(** The number of the vertex of B. *)

val equal : t -> t -> bool
(** [equal p q] is true if both are made of the same vertices. *)

val none : t
(** A value that differs from all points of vertices. *)

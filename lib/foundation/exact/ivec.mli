(** Integer vectors: coordinates over a denominator that their owner keeps. *)

type t = { x : Z.t; y : Z.t; z : Z.t }

val zero : t
val make : Z.t -> Z.t -> Z.t -> t
val of_ints : int -> int -> int -> t
val add : t -> t -> t
val sub : t -> t -> t
val neg : t -> t
val scale : Z.t -> t -> t
val dot : t -> t -> Z.t
val cross : t -> t -> t

val det : t -> t -> t -> Z.t
(** [det a b c] is a . (b x c). *)

val is_zero : t -> bool
val equal : t -> t -> bool
val compare : t -> t -> int
val hash : t -> int

val primitive : t -> t
(** The shortest integer vector of the same direction; zero stays zero. *)

val to_vec : t -> Vec.t

val is_integral : Vec.t -> bool
(** Whether all coordinates are integers: then {!numerators} are the coordinates. *)

val numerators : Vec.t -> t

val of_vec : Vec.t -> t * Z.t
(** [of_vec v] is [(n, d)] with v = n/d and d > 0 the least common denominator. *)

val of_vecs : Vec.t array -> t array * Z.t
(** The same for all of the array, over one denominator. *)

val to_string : t -> string

(** Integer vectors: the numerators of coordinates over a common denominator, which is kept elsewhere. *)

type t = { x : Z.t; y : Z.t; z : Z.t }

val zero : t
(** (0, 0, 0). *)

val make : Z.t -> Z.t -> Z.t -> t
(** [make x y z] is the vector (x, y, z). *)

val of_ints : int -> int -> int -> t
(** [of_ints x y z] is the vector (x, y, z). *)

val add : t -> t -> t
(** [add a b] is a + b. *)

val sub : t -> t -> t
(** [sub a b] is a - b. *)

val neg : t -> t
(** [neg a] is -a. *)

val scale : Z.t -> t -> t
(** [scale k a] is k a. *)

val dot : t -> t -> Z.t
(** [dot a b] is the scalar product a . b. *)

val cross : t -> t -> t
(** [cross a b] is the cross product a x b. *)

val det : t -> t -> t -> Z.t
(** [det a b c] is a . (b x c). *)

val is_zero : t -> bool
(** [is_zero a] is true for the zero vector. *)

val equal : t -> t -> bool
(** [equal a b] is true if all coordinates are equal. *)

val compare : t -> t -> int
(** The lexicographic order of the coordinates. *)

val hash : t -> int
(** A hash that is equal for equal vectors. *)

val primitive : t -> t
(** [primitive a] is the shortest integer vector of the same direction; zero stays zero. *)

val to_vec : t -> Vec.t
(** [to_vec a] is the rational vector with these coordinates. *)

val is_integral : Vec.t -> bool
(** [is_integral v] is true if all coordinates are integers. Then {!numerators} are the coordinates. *)

val numerators : Vec.t -> t
(** [numerators v] is the numerator of each coordinate, in lowest terms, whatever its denominator. *)

val of_vec : Vec.t -> t * Z.t
(** [of_vec v] is [(n, d)] with v = n/d and d > 0 the least common denominator. *)

val of_vecs : Vec.t array -> t array * Z.t
(** [of_vecs vs] is the numerators of all vectors over one denominator, and this denominator d > 0: the least
    common one. *)

val to_string : t -> string
(** [to_string a] is ["(x, y, z)"]. *)

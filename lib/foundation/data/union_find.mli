(** Disjoint sets of the numbers 0 to n - 1, which can be joined. *)

type t

val create : int -> t
(** [create n] has each of [n] numbers in a set of its own. *)

val find : t -> int -> int
(** [find t i] is the representative of the set of [i]: its least element. *)

val union : t -> int -> int -> bool
(** [union t i j] joins the sets of [i] and [j]. It returns [false] if they were one set already. *)

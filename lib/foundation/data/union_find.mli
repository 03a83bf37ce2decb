(** Disjoint sets of the numbers 0 to n - 1, which can be joined. *)

type t

val create : int -> t
(** Each number alone. *)

val find : t -> int -> int
(** The representative of the set of a number: the least of the set. *)

val union : t -> int -> int -> bool
(** Joins the two sets; [false] when they are one already. *)

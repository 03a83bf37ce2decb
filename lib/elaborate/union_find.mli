(** Disjoint sets of 0 … n - 1: to tell trees from graphs with cycles. *)

type t

val create : int -> t
val find : t -> int -> int
(** The representative of the set of an element. *)

val union : t -> int -> int -> bool
(** Joins the two sets; [false] when they are one already. *)

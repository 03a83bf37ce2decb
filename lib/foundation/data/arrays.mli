(** Comparisons of arrays by their elements. *)

val equal : ('a -> 'a -> bool) -> 'a array -> 'a array -> bool
(** [equal same a b] is true if [a] and [b] have one length and, by [same], equal elements at each place. *)

val compare : ('a -> 'a -> int) -> 'a array -> 'a array -> int
(** [compare order a b] compares the lengths, and then the elements in turn by [order]. *)

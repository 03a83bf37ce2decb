(** What several modules do with lists. All of it takes constant stack. *)

val pairs : 'a list -> ('a * 'a) list
(** Each two elements once, the earlier one first; in the order of the first, then of the second. *)

val neighbours : 'a list -> ('a * 'a) list
(** Each element with the next one; none for the last. *)

val ring : 'a list -> ('a * 'a) list
(** As {!neighbours}, and the last with the first: of one element, it with itself. *)

val take : int -> 'a list -> 'a list
(** The first so many, or all if there are fewer. *)

val put : ('a -> 'a option) -> 'a -> 'a list -> 'a list
(** [put joined x list]: the first [y] for which [joined y] is [Some z] becomes [z]; if there is none, [x] comes
    last. *)

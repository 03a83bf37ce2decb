(** Functions on lists that several modules use. All of them take constant stack. *)

val product : 'a list -> 'b list -> ('a * 'b) list
(** [product ones twos] is each element of [ones] with each of [twos], those with the first one first. *)

val pairs : 'a list -> ('a * 'a) list
(** [pairs [a; b; c]] is [[(a, b); (a, c); (b, c)]]: each two elements once, the earlier one first. *)

val neighbours : 'a list -> ('a * 'a) list
(** [neighbours [a; b; c]] is [[(a, b); (b, c)]]: each element but the last with the next one. *)

val ring : 'a list -> ('a * 'a) list
(** [ring [a; b; c]] is [[(a, b); (b, c); (c, a)]]: {!neighbours}, then the last element with the first. A single
    element is paired with itself. *)

val take : int -> 'a list -> 'a list
(** [take n list] is the first [n] elements, or all if there are fewer. *)

val merged : ('a -> 'a -> int) -> ('b -> 'b -> 'b) -> ('a * 'b) list -> ('a * 'b) list
(** [merged compare add list] has each key of [list] once, in the order of [compare]. The values of equal keys are
    put together by [add], in the order of the list. *)

val distinct : ('a -> 'a -> bool) -> 'a list -> 'a list
(** [distinct equal list] is [list] without the elements that are equal to an earlier one. *)

val put : ('a -> 'a option) -> 'a -> 'a list -> 'a list
(** [put joined x list] replaces the first [y] for which [joined y] is [Some z] by [z]. If there is none, it
    appends [x]. *)

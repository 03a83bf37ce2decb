(** Arrays that may be long, made of new values.

    An array of more than 256 words whose first element was just allocated is expensive in OCaml: the minor heap is
    emptied, and a major slice follows. The functions of the standard library pay this price: for an array of a
    thousand elements it takes longer than all the rest. The functions of this module join short arrays instead. *)

val init : int -> (int -> 'a) -> 'a array
(** [init n f] is as [Array.init], for [n >= 0]. [f] is called in increasing order. *)

val of_list : 'a list -> 'a array
(** [of_list list] is as [Array.of_list]. *)

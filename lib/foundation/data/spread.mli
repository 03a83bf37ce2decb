(** Iteration over arrays in an order that mixes their parts. *)

val iter : ('a -> unit) -> 'a array -> unit
(** [iter f a] calls [f] once for each element, in steps of about the golden section of the length. A tree that is
    built by single insertions in the order of rows gets long nodes near its root, which stay. This order avoids
    them. *)

(** The names that every file of [lib/] sees without opening a module ([lib/dune]). *)

val ( let* ) : ('a, 'e) result -> ('a -> ('b, 'e) result) -> ('b, 'e) result
(** [let* x = r in e] is [e] with the value of [r] for [x], or the error of [r]. Files that work with options
    instead define it anew. *)

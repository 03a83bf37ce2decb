(** Functions of {!List} that take constant stack however long the list is: before OCaml 5.1 those of the
    standard library do not. Elements are visited from the first to the last. *)

val map : ('a -> 'b) -> 'a list -> 'b list
val mapi : (int -> 'a -> 'b) -> 'a list -> 'b list
val append : 'a list -> 'a list -> 'a list
val concat : 'a list list -> 'a list

(** Arrays that may be long, made of new values.

    Before OCaml makes an array of more than 256 words of a value that it has just allocated, as all functions of
    the standard library do that begin with a first element, it empties its minor heap and goes on with a major
    collection: for an array of a thousand that takes longer than all the rest. These put short arrays together. *)

val init : int -> (int -> 'a) -> 'a array
(** As [Array.init], of a length >= 0: the function is asked in order. *)

val of_list : 'a list -> 'a array
(** As [Array.of_list]. *)

(** Pieces of texts. *)

val place : ?nth:int -> string -> string -> int
(** [place ?nth text piece] is where a piece of a text begins: the first of them, or the one with the number [nth]
    from 0. If there is none, the test fails. *)

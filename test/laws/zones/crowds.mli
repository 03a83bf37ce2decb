(** Models with bodies that are alike, and come to be where another one was. *)

val pick : 'a list -> 'a

val text : unit -> string
(** A random one, with checks. *)

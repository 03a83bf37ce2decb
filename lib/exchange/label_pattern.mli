(** Patterns for the texts of transition labels ([time(1/2)], [bounce(p, q)]), to choose those that are not to be seen. *)

type t

val of_string : string -> (t, string) result
(** [*] stands for any characters, also none; everything else for itself. A word without brackets and stars
    ([bounce]) stands for all labels of this kind. An error for the empty text. *)

val to_string : t -> string

val matches : t -> string -> bool
(** The whole text. *)

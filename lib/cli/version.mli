(** The version of the program. *)

val current : string

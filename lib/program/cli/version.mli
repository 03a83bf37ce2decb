(** The version of the program. *)

val current : string
(** The version of the program, such as ["0.1.0"]. *)

val told : string
(** The version with that of the semantics: ["0.1.0 (semantics 3)"]. *)

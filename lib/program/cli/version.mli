(** The version of the program. *)

val current : string

val told : string
(** With that of the semantics: ["0.1.0 (semantics 3)"]. *)

(** Which model a trace or a schedule is of. *)

val make : text:string -> files:(string * string) list -> string
(** ["md5:…"], the MD5 of the bytes of the model's text and of the mesh files that it reads, each as its
    path as written, its length and its bytes. It tells models apart; it is no defence against somebody
    who wants to deceive. *)

(** Messages of the operating system. *)

val reason : string -> string -> string
(** [reason path message] is the message of a [Sys_error] about [path] without the path before it. *)

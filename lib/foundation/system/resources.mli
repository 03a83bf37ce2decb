(** What the system has no more of to give: memory, processes, places for open files. *)

val refused : exn -> string option
(** Of an exception that tells so, what it is, in words. *)

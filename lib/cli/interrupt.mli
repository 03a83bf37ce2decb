(** Interruption from the keyboard or by a request to end (SIGINT, SIGTERM). *)

val install : unit -> unit -> bool
(** [install ()] catches the signals from now on; the function that it returns tells whether one has
    arrived. The second one ends the program at once, as if none were caught. *)

(** Standard input, output and error, whatever the program was started with. *)

val secure : unit -> unit
(** Takes the places of those that are closed, so that no file that is opened later gets the number of one, and is
    read or written in its stead. What is there instead cannot be read (of standard input) or written (of the
    others): it fails as a closed one does. *)

(** Standard input, output and error, whatever the program was started with. *)

val secure : unit -> unit
(** [secure ()] opens a stand-in for each of them that is closed. So no file that is opened later gets its number,
    and is read or written in its stead. A stand-in for standard input fails when it is read, and one for the
    others when it is written. It does nothing on Windows. *)

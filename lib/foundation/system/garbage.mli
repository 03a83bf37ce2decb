(** The memory that the program holds without need. *)

val compact : unit -> unit
(** Collects all garbage and gives the memory back to the system, as far as the C library can. Without that, the
    measured memory of a program of OCaml 5 stays what it was after its data are gone. *)

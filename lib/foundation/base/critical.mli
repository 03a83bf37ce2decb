(** Sections that must not be left half done.

     Work that takes too long is given up by an exception that a timer raises wherever the program happens
    to be. A table that is being changed there would be left in pieces, and is used again by what is still
    told: so those few places ask for a moment's peace. *)

val run : (unit -> 'a) -> 'a
(** Does it all, or fails by itself. It has to be short. *)

val active : unit -> bool
(** Whether such a section is being run; who would give up waits for the next time. *)

val enter : unit -> unit
val leave : unit -> unit
(** The two ends of a section that raises nothing, where a function would cost too much. *)

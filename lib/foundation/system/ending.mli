(** The outermost guard: how the program begins and ends, whatever happens.

    An exception that nobody has caught gives the exit code 2 in OCaml, which here is a verdict. It may come before
    the first line of the program, from a library that is being set up, and after the last one, from a channel
    that is flushed. This module is linked before all others, and leaves nothing to be done at the end. *)

val run : (unit -> int) -> 'a
(** Ends the program with this exit code; with 4 after {!Interruption.Interrupted} or for want of what the system
    gives, with 70 after any other exception. *)

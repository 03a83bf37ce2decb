(** The outermost guard: how the program begins and ends, in all cases.

    OCaml ends a program after an uncaught exception with exit code 2, which is a verdict of scc. Such an exception
    may come before the first line of the program, from the initialisation of a library. It may also come after the
    last one, from a channel that is flushed. So this module is linked before all others, and ends the program
    without the functions of [at_exit]. *)

val run : (unit -> int) -> 'a
(** [run main] ends the program with the exit code [main ()]. The exit code is 4 after {!Interruption.Interrupted}
    or if the system refuses a resource ({!Resources.refused}), and 70 after any other exception. The message of an
    exception goes to standard error. *)

(** Several suites in one program: linking is what most of the time of a small one goes into. *)

val run : (string * unit Alcotest.test list) list -> unit
(** Runs the groups of all suites as one suite, so that a filter on the command line finds a group of any of them.
    Groups of equal names are one. Ends the program with 1 if a test fails. *)

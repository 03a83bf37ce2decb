(** Several suites in one program: linking is what most of the time of a small one goes into. *)

val run : (string * unit Alcotest.test list) list -> unit
(** Runs all of them, whatever fails; ends the program with 1 if anything did. *)

(** Files that are there as a whole or not at all: the one way in which files are written.

     The bytes go to a new file in the same folder, which takes the place of the old one, with its mode,
    once all of it is on the disk. Links are followed and stay. When something fails, or is interrupted by
    an exception, what was there before is still there, and nothing else. What is no regular file (a pipe, a
    device) is written to directly. *)

open Scc_base

val write : (string * ((string -> unit) -> unit)) list -> (unit, Diag.t) result
(** [write files] gives to each function of [files], in order, what writes to the file of that path; they are
    put in place when all are complete. SC0103 when a file cannot be written. Exceptions of the functions
    pass through. *)

val with_pieces : string -> ((string -> unit) -> 'a) -> ('a, Diag.t) result
(** Of a file in pieces, of which each is of use with those before it: the function is given what writes a whole
    piece. When one cannot be written (the disk is full), those before it are put in place, if there are two at
    least (the first may be a header), and SC0103 says so. *)

val with_file : string -> ((string -> unit) -> 'a) -> ('a, Diag.t) result
(** The same of one, with what the function gives. *)

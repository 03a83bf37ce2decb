(** Files that are there as a whole or not at all. *)

open Scc_base

val write : (string * ((string -> unit) -> unit)) list -> (unit, Diag.t) result
(** [write files] gives to each function of [files], in order, what writes to the file of that path. The bytes
    go to new files beside them, which take their places once all are complete: when something fails, or is
    interrupted by an exception, what was there before is still there. What is no regular file (a pipe, a
    device, a link) is written in place. SC0103 when a file cannot be written. Exceptions of the functions
    pass through. *)

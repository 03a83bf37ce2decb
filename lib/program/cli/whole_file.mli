(** Files that are complete or not there at all. All files are written in this way.

    The bytes go to a new file in the same folder. Once all of it is on the disk, it replaces the old file and
    takes its mode. Links are followed and stay. If writing fails, or an exception interrupts it, the old file
    is unchanged and there is no other. A file that is not regular (a pipe, a device) is written to directly. *)

open Scc_base

exception Failed of Diag.t
(** What the functions that write to a file raise where it cannot be written (SC0103). *)

val target : ?links:int -> string -> string
(** [target path] is the file that a path leads to through links, whether or not it is there. [links] is how many
    have been followed. *)

val write : (string * ((string -> unit) -> unit)) list -> (unit, Diag.t) result
(** [write files] calls each function, in order, with a function that writes to the file of its path. The files
    are put in place when all are complete. A file that cannot be written is SC0103. Exceptions of the functions
    pass through. *)

val with_pieces : string -> ((string -> unit) -> 'a) -> ('a, Diag.t) result
(** [with_pieces path f] calls [f] with a function that writes one whole piece of the file; each piece must be
    useful with those before it. If a piece cannot be written (the disk is full), the pieces before it are put
    in place, if they are two at least (the first may be a header). The error is SC0103. *)

val with_file : string -> ((string -> unit) -> 'a) -> ('a, Diag.t) result
(** [with_file path f] calls [f] with a function that writes to the file, and returns the result of [f]. A file
    that cannot be written is SC0103. *)

(** The sources of [lib/], as the compiler's own parser reads them. *)

val state : unit -> (string * string) list
(** Values that can change and live as long as the program: made when a module is initialised, not by a function.
    Each has a file of [lib/] without its ending ([foundation/system/standard]) and a name. References, tables,
    buffers, arrays, and records of a type of the same file with mutable fields are found. *)

val longest : most:int -> string list
(** The functions with more lines than [most], nested ones included, each with its place and its number of
    lines. *)

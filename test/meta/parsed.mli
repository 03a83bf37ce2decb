(** The sources of [lib/], as the compiler's own parser reads them. *)

val unlisted_state : unit -> string list
(** Values that can change and live as long as the program (made when a module is initialised, not by a function),
    as far as [state.txt] does not list them with a reason; and lines of [state.txt] without such a value.
    References, tables, buffers, arrays, and records of a type of the same file with mutable fields are found. *)

val longest : most:int -> string list
(** The functions with more lines than [most], nested ones included, each with its place and its number of
    lines. *)

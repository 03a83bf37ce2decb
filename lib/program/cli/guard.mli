(** The last net: whatever happens, scc ends with a message and a documented exit code. *)

open Scc_base
open Scc_session

val invalid : Console.t -> Diag.t list -> Exit_code.t
(** Reports why there can be no result: exit 3, or 74 when it is only that an output could not be written,
    or 64 when it is only the command line that is wrong ({!Span.command_line}). In JSON mode the
    diagnostics are the document. *)

val stopped : Console.t -> string -> Exit_code.t
(** Tells what ended the work before there was a result: exit 4. In JSON mode there is a document without
    diagnostics. *)

val complain : string list -> unit
(** Lines to standard error, whatever else is written as a document. *)

val complain_of : Console.t -> Diag.t -> unit
(** Of what is wrong, likewise. *)

val usage : string -> Exit_code.t
(** Says what is wrong with the command line: exit 64. *)

val by_ending :
  string ->
  endings:string list ->
  what:string ->
  (string -> 'a option) ->
  (string * 'a -> Exit_code.t) -> Exit_code.t
(** Goes on with a file to be written and what is found for the ending of its name; {!usage} if nothing is. *)

val run : Console.t -> (unit -> (Exit_code.t, Diag.t list) result) -> Exit_code.t
(** Runs a command; diagnostics are {!invalid}. Turns exceptions into exit codes: an output that failed (74), an
    output that nobody reads any more (4, silently), no memory left (4), our own bugs and everything unforeseen
    (70). So does a fault that was kept ({!Console.fault}), once the command has told all else. *)

val run_on_two :
  Console.t -> string -> string -> (unit -> (Exit_code.t, Diag.t list) result) -> Exit_code.t
(** The same of a command that reads two files, not both of which can be standard input. *)

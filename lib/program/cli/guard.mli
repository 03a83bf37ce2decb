(** The last handler of errors: whatever happens, scc ends with a message and a documented exit code. *)

open Scc_base
open Scc_verdicts

val invalid : Console.t -> Diag.t list -> Exit_code.t
(** Reports why there is no result. The exit code is 74 if all diagnostics are of outputs that cannot be
    written, 64 if all are of the command line ({!Span.command_line}), and 3 otherwise. In JSON mode the
    diagnostics are the document. *)

val stopped : Console.t -> string -> Exit_code.t
(** Reports why the work ended before there was a result: exit code 4. In JSON mode there is a document with the
    reason and without diagnostics. *)

val complain : string list -> unit
(** Writes lines to standard error, also in JSON mode. *)

val complain_of : Console.t -> Diag.t -> unit
(** Writes a diagnostic, with the place in its text, to standard error, also in JSON mode. *)

val usage : string -> Exit_code.t
(** Reports an error of the command line: exit code 64. *)

val unwritten : Console.t -> (unit, Diag.t list) result list -> Exit_code.t
(** [unwritten console results] reports the errors of several outputs, each of which was tried: the code is the
    worst of theirs. *)

val by_ending :
  string ->
  endings:string list ->
  what:string ->
  (string -> 'a option) ->
  (string * 'a -> Exit_code.t) -> Exit_code.t
(** [by_ending path ~endings ~what find go] calls [go] with the path and the format that [find] gives for it.
    Without one it is {!usage}. *)

val run :
  ?outputs:Outputs.output list ->
  Console.t -> (unit -> (Exit_code.t, Diag.t list) result) -> Exit_code.t
(** Runs a command; its diagnostics are {!invalid}. [outputs] are the files that it
    writes: if two of them are one file, or one of them is an input, that is {!usage} ({!Console.declare},
    {!Console.reads}). Exceptions become exit codes: an output that failed (74), an
    output whose reader has closed it (4, silently), no memory left (4), bugs and everything unforeseen (70). A
    fault that was kept ({!Console.fault}) also gives 70, after all other output. Requests to end the program that
    came before it are answered first ({!Scc_system.Interruption.heed}): in JSON mode by a document. *)

val around : Console.t -> (unit -> (Exit_code.t, Diag.t list) result) -> Exit_code.t
(** [around console main] is {!run} for what chooses the command. Requests to end the program still wait. *)

val run_on_two :
  ?outputs:Outputs.output list ->
  Console.t -> string -> string -> (unit -> (Exit_code.t, Diag.t list) result) -> Exit_code.t
(** Runs a command that reads two files, as {!run} does. Both cannot be standard input (exit code 64). *)

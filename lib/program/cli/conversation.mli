(** Commands that answer the lines of standard input on standard output, until the input ends. *)

open Scc_verdicts

(** The output of a conversation, with a buffer. *)
type t

val hold : (t -> Exit_code.t) -> Exit_code.t
(** Runs a conversation and sends the rest of its output at the end. The result is {!Exit_code.Stopped} if the
    reader has closed the output. An interruption raises {!Scc_system.Interruption.Interrupted}, but never
    during a write. Raises {!Console.Output_failed} if the output cannot be written. *)

val say : t -> string -> unit
(** Adds a line, given without its end. It is sent by {!send}, or when there is much output. *)

val add : t -> (Buffer.t -> 'a) -> 'a
(** Calls a function that appends to the buffer of the output, and sends the buffer when there is much in it. *)

val send : t -> unit
(** Writes the buffered output. *)

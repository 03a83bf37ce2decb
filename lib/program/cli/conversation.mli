(** Commands that answer on standard output what comes in on standard input, until that ends. *)

open Scc_session

type t

val hold : (t -> Exit_code.t) -> Exit_code.t
(** All that was said is sent off at the end. {!Exit_code.Stopped} where nobody reads it any more. An interruption
    raises {!Scc_system.Interruption.Interrupted}, but never while something is written.
    {!Console.Output_failed} where it cannot be written. *)

val say : t -> string -> unit
(** A line, given without its end. What is said waits until {!send}, or there is much of it. *)

val add : t -> (Buffer.t -> 'a) -> 'a
(** The same of what the function puts at the end of the buffer. *)

val send : t -> unit

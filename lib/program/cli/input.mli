(** Reading files and models. *)

open Scc_base
open Scc_exact

val max_bytes : int
(** Files larger than this (64 MiB) are refused. *)

val read : ?max_bytes:int -> string -> (Source.t, Diag.t) result
(** The bytes of a file; ["-"] is standard input. SC0101 when it cannot be read. Not more than {!max_bytes},
    unless told otherwise. *)

val standard_input : string
(** How it is called. *)

val cannot_read : string -> string -> Diag.t
(** [cannot_read name reason]: SC0101. *)

val mesh_reader : Console.t -> string -> Scc_session.Loaded.reader
(** [mesh_reader c model path] reads a mesh file that a model names, relative to the model's place. *)

val text : Console.t -> string -> (Source.t, Diag.t list) result
(** The same, and the text becomes known to the console. *)

val warned : Console.t -> string -> (Source.t, Diag.t list) result
(** The same, and what {!Direction.warnings} finds is reported: for commands that read a text and load no model. *)

val given : Console.t -> name:string -> string -> Source.t
(** The same of a text that the command line has. *)

val check_overrides : string list -> (unit, Diag.t list) result
(** Of the names of the parameters that are given values: no two for one (SC0212). *)

val model :
  ?given:Span.t ->
  ?narrowed:(string * (Scc_calculus.Ranges.bound * Scc_calculus.Ranges.bound)) list ->
  ?source:Source.t ->
  Console.t ->
  overrides:(string * Rat.t) list ->
  string ->
  (Scc_session.Loaded.t, Diag.t list) result
(** Reads and loads the file, or [source] as if it were what is in the file. Its texts become known to the console.
    [given] is where the values of [overrides] come from, the command line if nothing is said. *)

(** Where a command speaks: results to standard output, diagnostics and progress to standard error. *)

open Scc_base

type color = Always | Never | Auto

type t

exception Output_failed of Diag.t
(** An output that cannot be written (SC0103). *)

exception Output_closed
(** Standard output is a pipe that nobody reads any more. *)

val output_failed : string -> string -> exn
(** {!Output_failed}, of what has this name, for this reason. *)

val make : ?progress:(string -> unit) -> color:color -> json:bool -> unit -> t
(** With [json], diagnostics are kept for the JSON report instead of being shown. [progress] takes the lines of
    {!progress} instead of the terminal. *)

val is_terminal : Unix.file_descr -> bool

val is_json : t -> bool

val add_source : t -> Source.t -> unit
(** Makes a text known, so that diagnostics can show excerpts of it. *)

val source : t -> string -> Source.t option

val print : t -> string -> unit
(** To standard output. *)

val tell : t -> string -> unit
(** A text for people to standard output, as {!Visible.text} shows it, but for {!styled}. *)

val answer : t -> json:(unit -> Scc_exchange.Json.t) -> text:(unit -> string) -> unit
(** The result of a command, as one document or for people, and sends it off. *)

val report : t -> Diag.t list -> unit
(** Shows diagnostics on standard error (not in [json] mode). *)

val kept : t -> Diag.t list
(** What [report] was given, in order. *)

val fault : t -> string -> unit
(** Keeps a fault of scc by which something is missing, while all else is told: see {!Guard.run}. *)

val faults : t -> string list
(** Those that were kept, in order. *)

val note : t -> string -> unit
(** A line to standard error (not in [json] mode). *)

val progress : t -> string -> unit
(** Replaces the line of progress: on a terminal alone, unless it goes elsewhere ({!make}). *)

val progress_done : t -> unit

(** How to print a word of a report. *)
type style = Good | Bad | Doubtful | Strong | Faint

val styled : t -> style -> string -> string
(** With colours when standard output has them. *)

val with_output : ?pieces:bool -> t -> path:string option -> ((string -> unit) -> 'a) -> ('a, Diag.t) result
(** [with_output c ~path f] gives [f] a function that writes to the file ({!Whole_file}), or to standard output
    without [path], where it raises {!Output_failed} or {!Output_closed}. With [pieces], what is whole of a file
    stays when it cannot be written to its end ({!Whole_file.with_pieces}). *)

val flush : t -> unit
(** Sends off what is printed so far. *)

(** The output of a command: results to standard output, diagnostics and progress to standard error. *)

open Scc_base

(** When colours are used. *)
type color = Always | Never | Auto

(** The output of one command. *)
type t

exception Output_failed of Diag.t
(** An output that cannot be written (SC0103). *)

exception Output_closed
(** Standard output is a pipe whose reader has closed it. *)

val output_failed : string -> string -> exn
(** [output_failed name reason] is {!Output_failed} for the output with this name. *)

exception Refused of string
(** Files of a command that do not go together: the sentence says so. *)

val make : ?progress:(phase:bool -> string -> unit) -> color:color -> json:bool -> unit -> t
(** A console. With [json], diagnostics are kept for the JSON report instead of being shown. [progress] receives
    the lines of {!progress} instead of the terminal. *)

val is_terminal : Unix.file_descr -> bool
(** [is_terminal fd] is true if the descriptor is a terminal. *)

val is_json : t -> bool
(** [is_json c] is true if the result is a JSON document. *)

val add_source : t -> Source.t -> unit
(** Adds a text, so that diagnostics can show excerpts of it. *)

val source : t -> string -> Source.t option
(** The text with this name, if it has been added. *)

val declare : t -> Outputs.output list -> unit
(** [declare c outputs]: the command writes these files, too. From now on, standard output that fails ends nothing:
    the failure is kept ({!lost}), so that the files are written all the same. Raises {!Refused} if two outputs are
    one file ({!Outputs.add}), or one of them has been read. *)

val reads : t -> string -> unit
(** [reads c path]: the command reads this file. Raises {!Refused} if it is one of its outputs. *)

val lost : t -> exn option
(** [lost c] is {!Output_failed} or {!Output_closed}, if standard output has failed beside other outputs. *)

val print : t -> string -> unit
(** Writes to standard output. Without other outputs ({!declare}), it raises {!Output_failed} or
    {!Output_closed}. *)

val tell : t -> string -> unit
(** A text for people to standard output, as {!Visible.text} shows it, but for {!styled}. *)

val answer : t -> json:(unit -> Scc_json.Json.t) -> text:(unit -> string) -> unit
(** Writes the result of a command, as one document or as text, and flushes it. *)

val answer_and_write :
  t -> json:(unit -> Scc_json.Json.t) -> text:(unit -> string) -> (unit -> (unit, 'e) result) -> (unit, 'e) result
(** [answer_and_write c ~json ~text write] is {!answer} together with [write ()], which writes files. A report in
    text comes before the files, and is there whatever becomes of them. A document comes after them, and only if
    all were written: the error has a document of its own, with another exit code. *)

val document : t -> Scc_json.Json.t -> unit
(** [document c json] prints the one document of a command, and flushes it. A request to end that comes while it is
    written does not change the exit code, which the document contains ({!Scc_system.Interruption.settle}). *)

val report : t -> Diag.t list -> unit
(** Shows diagnostics on standard error (not in [json] mode), and keeps them. *)

val kept : t -> Diag.t list
(** The diagnostics of {!report}, in order. *)

val fault : t -> string -> unit
(** Keeps a fault of scc by which part of a result is missing: see {!Guard.run}. *)

val faults : t -> string list
(** The faults that were kept, in order. *)

val note : t -> string -> unit
(** Writes a line to standard error (not in [json] mode). *)

val progress : t -> string -> unit
(** Replaces the line of progress, on a terminal only, or passes it to the function of {!make}. *)

val phase : t -> string -> unit
(** [phase console line] shows what begins now, before there are numbers to show, where {!progress} shows its
    line. *)

val progress_lines : unit -> phase:bool -> string -> unit
(** [progress_lines ()] is a function for {!make} that writes lines of progress to standard error, each as
    ["progress: "], the text and a newline: those of a phase, and at most ten others a second. *)

val progress_done : t -> unit
(** Removes the line of progress. *)

(** The style of a word in a report. *)
type style = Good | Bad | Doubtful | Strong | Faint

val styled : t -> style -> string -> string
(** The text with colours, if standard output has them. *)

val with_output : ?pieces:bool -> t -> path:string option -> ((string -> unit) -> 'a) -> ('a, Diag.t) result
(** [with_output c ~path f] calls [f] with a function that writes to the file ({!Whole_file}). Without [path],
    and if it is ["-"], the function writes to standard output, and raises {!Output_failed} or {!Output_closed}.
    With [pieces], the complete pieces of a file are kept if it cannot be written to its end
    ({!Whole_file.with_pieces}). *)

val with_main_output :
  ?pieces:bool -> t -> path:string option -> ((string -> unit) -> 'a) -> 'a option * (unit, Diag.t) result
(** [with_main_output c ~path f] is {!with_output} for a result that other outputs depend on. If there are any
    ({!declare}), [f] is run to its end whatever becomes of its own output, and its result is there. *)

val flush : t -> unit
(** Flushes standard output. Raises {!Output_failed} or {!Output_closed}. *)

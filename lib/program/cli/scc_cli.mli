(** The command line of scc. *)

val main : unit -> int
(** Reads the command line, runs the command and returns the exit code (see {!Scc_verdicts.Exit_code}). *)

(** {1 Formats of documents} *)

module Compare_json = Compare_json
module Inflate_command = Inflate_command

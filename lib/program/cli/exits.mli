(** The exit codes in the manuals. *)

open Scc_session

val man : ?told:(Exit_code.t * string) list -> ?never:Exit_code.t list -> unit -> Cmdliner.Cmd.Exit.info list
(** Of a command: with the words of [told] instead of {!Exit_code.meaning}, and without the codes of [never]. *)

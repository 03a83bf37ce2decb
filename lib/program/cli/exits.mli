(** The exit codes in the manuals. *)

open Scc_verdicts

val man : ?told:(Exit_code.t * string) list -> ?never:Exit_code.t list -> unit -> Cmdliner.Cmd.Exit.info list
(** The exit codes for the manual of a command. [told] replaces the texts of {!Exit_code.meaning}, and the codes
    of [never] are left out. *)

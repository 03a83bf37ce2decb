(** The manual of [scc compare]. *)

val text : Cmdliner.Manpage.block list
(** The sections of the manual page. *)

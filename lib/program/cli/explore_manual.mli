(** The text of the manual of [scc explore]. *)

val text : Cmdliner.Manpage.block list
(** The sections of the manual page. *)

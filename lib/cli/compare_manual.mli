(** The manual of [scc compare]. *)

val text : Cmdliner.Manpage.block list
val exits : Cmdliner.Cmd.Exit.info list

(** The methods about texts of models that are being written: they need not mean anything yet. *)

val format : Read.params -> Reply.t

val describe : read_file:Scc_session.Loaded.reader -> Read.params -> Reply.t
(** Of modules that are imported it tells what they declare, if they can be read. *)

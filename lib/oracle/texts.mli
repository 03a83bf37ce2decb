(** The methods about texts of models that are being written: they need not mean anything yet. *)

val format : Read.params -> Reply.t

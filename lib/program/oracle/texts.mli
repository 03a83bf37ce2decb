(** The methods about texts of models in an editor, which may still have errors. *)

val format : Read.params -> Reply.t
(** The method [text.format]. *)

val describe : read_file:Scc_loading.Loaded.reader -> Read.params -> Reply.t
(** The method [text.describe]. [read_file] reads imported modules, whose declarations are described if they can
    be read. *)

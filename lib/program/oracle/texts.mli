(** The methods about texts of models in an editor, which may still have errors. *)

val format : unit Method.t
(** The method [text.format]. *)

val describe : Scc_loading.Loaded.reader Method.t
(** The method [text.describe]. The reader reads imported modules, whose declarations are described if they can
    be read. *)

val complete : Scc_loading.Loaded.reader Method.t
(** The method [text.complete]. The reader reads imported modules. *)

val fixes : Scc_loading.Loaded.reader Method.t
(** The method [text.fixes]. The reader reads imported modules and meshes. *)

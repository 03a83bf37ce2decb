(** Declarations by parts of their names. *)

open Scc_json

val symbols : Session.t -> Json.t -> Json.t
(** The declarations of the open documents, and of the files that they import, whose names contain the member
    [query] in any case of letters. At most 1 000 are found: names that are the query before those that begin with
    it, and these before others. Files are read, which may take long. *)

(** The files that a text belongs with: those that it imports, and those that import it. *)

open Scc_describe

(** A text of the project. *)
type file = { path : string; reading : Reading.t; positions : Positions.t }

val imports : Workspace.t -> file -> file list
(** The files that a text imports, with theirs, each once. A cycle is no error here. *)

val importers : Workspace.t -> folders:string list -> string -> file list
(** The open documents, and the models in these folders and below, that import the file at a path by themselves. At
    most 10 000 files are looked at; folders whose names begin with a dot are left out. *)

val resolves : base:string -> file:string -> string -> bool
(** [resolves ~base ~file path] is true if the import of [file] in a text with the path [base] names [path]. *)

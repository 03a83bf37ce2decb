(** The files that a text belongs with: those that it imports, and those that import it. *)

open Scc_describe

(** A text of the project. *)
type file = { path : string; reading : Reading.t; positions : Positions.t }

val of_document : Workspace.document -> file
(** The document as a text of the project. One that has not been saved has its address for a path. *)

val base : file -> string option
(** The path by which a text names its imports; none if it has not been saved. *)

val address : Workspace.t -> file -> string
(** The address of a text: that of its document, if it is open. *)

val imports : Workspace.t -> file list -> file list
(** The files that some texts import, with theirs, each once, and without the texts. A cycle is no error here. At
    most 10 000 files are read. *)

val importers : Workspace.t -> folders:string list -> string -> file list
(** The open documents, and the models in these folders and below, that import the file at a path by themselves. At
    most 10 000 files are looked at; folders whose names begin with a dot are left out. *)

val resolves : base:string -> file:string -> string -> bool
(** [resolves ~base ~file path] is true if the import of [file] in a text with the path [base] names [path]. *)

val contains : string -> string -> bool
(** [contains text part] is true if the part, which is not empty, stands in the text. *)

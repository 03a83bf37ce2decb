(** What is known of a document without exploring it. *)

open Scc_base

(** The result of reading a document. *)
type t = {
  diagnostics : Diag.t list;  (** those that [scc check] prints before it explores; of imports as well *)
  files : string list;  (** the paths of the files that were read, or could not be *)
  values : (Span.t * string) list;  (** exact values of names, by their places *)
  known : Scc_assist.Known.t;  (** its names *)
}

val known_of : Workspace.t -> Workspace.document -> Scc_assist.Known.t
(** The names of a document, for completion. *)

val of_document : Workspace.t -> Workspace.document -> t
(** Reads a document with its imports, up to its initial state. It may take long, and is called in a process of its
    own. *)

(** Diagnostics as the client has them. An address has those of its own text, and those that documents that import
    it were found to have there. *)

open Scc_json

(** What was sent. *)
type t

val create : Session.t -> send:(Json.t -> unit) -> t
(** Nothing was sent yet. [send] sends a message to the client. *)

val found : t -> Workspace.document -> Analysis.t -> unit
(** Publishes what was found of a document, in its text and in others. *)

val again : t -> Workspace.document -> unit
(** Publishes the diagnostics of a document with its present verdicts. *)

val forget : t -> string -> unit
(** Withdraws what was found of the document of this address, which is closed. *)

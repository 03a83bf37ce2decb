(** What a session knows: the client, the texts, and what was found of them. *)

open Scc_json

(** The verdict of a check. *)
type verdict = {
  name : string;  (** of the check *)
  kind : string;  (** ["holds"], ["violated"], … *)
  text : string;  (** the verdict in full *)
  run : string;  (** the report, with a run that shows it *)
  shown : bool;  (** there is such a run *)
}

type t = {
  client : Client.t;
  workspace : Workspace.t;
  analyses : (string, int * Analysis.t) Hashtbl.t;  (** by address: for which version *)
  verdicts : (string, verdict list) Hashtbl.t;  (** by address, of the present text *)
  sent_tokens : Sent_tokens.t;  (** of the last answers *)
}

val create : Client.t -> t
(** A session in which nothing is open. *)

val document : t -> Json.t -> Workspace.document
(** The open document of the member [textDocument]; raises {!Rpc.Refused} if it is not open. *)

val plain_document : t -> Json.t -> Workspace.document option
(** The document, if it is in the language of [specs/language.md]: texts of other notations have diagnostics and
    layout alone. *)

val offset : Workspace.document -> Json.t -> int
(** The offset of the member [position]. *)

val offsets : Workspace.document -> Json.t -> int * int
(** The offsets of the two ends of the member [range], the lesser first. *)

val is_large : Workspace.document -> bool
(** [is_large d] is true if reading the document takes longer than one should wait after a keystroke. *)

val known : t -> Workspace.document -> Scc_assist.Known.t
(** The names of a document, for completion; of a large one those that it had when it was last read. *)

val analysis : t -> Workspace.document -> Analysis.t option
(** What was found of the present text. *)

val verdicts : t -> Workspace.document -> verdict list
(** The verdicts of the present text. *)

val range : Workspace.document -> int -> int -> Json.t
(** The range between two offsets. *)

val markup : t -> string -> Json.t
(** A description as the client can show it. Its first line is prose, the others are text of a model. *)

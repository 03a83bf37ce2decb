(** From a name to its declaration and its other places, and new names. *)

open Scc_json

val definition : Session.t -> Json.t -> Json.t
(** The places at which the name at a place is declared; of a channel, where it is open. *)

val references : Session.t -> Json.t -> Json.t
(** All places of the name at a place, in the files that belong with the document. *)

val highlights : Session.t -> Json.t -> Json.t
(** The places of the name in the document itself. *)

val prepare_rename : Session.t -> Json.t -> Json.t
(** The range of the name at a place; raises {!Rpc.Refused} with {!Rpc.failed} if it cannot be renamed. *)

val rename : Session.t -> Json.t -> Json.t
(** The edits that give the name at a place a new one, in all files that belong with the document. Raises
    {!Rpc.Refused} with {!Rpc.failed} where {!Scc_assist.Rename.edits} has an error. *)

val edit : Session.t -> (string * Positions.t * Scc_assist.Rename.edit list) list -> Json.t
(** The change of a workspace of these edits, by addresses of documents. *)

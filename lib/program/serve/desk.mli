(** The model in the editor, and its file. *)

open Scc_json

(** The model and its file. *)
type t = {
  name : string;  (** of the model, as shown *)
  path : string option;  (** [None] if it has no file *)
  read : string -> (string, string) result;  (** the bytes of a file, or why it cannot be read *)
  write : string -> string -> (unit, string) result;  (** [write path bytes] writes a file *)
  parameters : (string * Json.t) list;
  (** values and ranges of the command line, as params of [model.load] *)
  start : string;  (** the initial text, if there is no file *)
}

val page_data : t -> Json.t
(** The initial data of the editor's page. *)

(** The result of saving. *)
type saved =
  | Saved of string  (** the digest of the new content of the file *)
  | Another of { text : string; digest : string }  (** the file has changed since it was read *)
  | Failed of string

val save : t -> text:string -> over:string option -> saved
(** Writes the text if the file still has the digest [over], or is still missing ([None]). *)

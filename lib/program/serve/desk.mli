(** The model that is worked on: the file that it is in, as the desk reads and writes it. *)

open Scc_exchange

type t = {
  name : string;  (** of the model, as shown *)
  path : string option;  (** none where it is in no file *)
  read : string -> (string, string) result;  (** the bytes of a file, or why they cannot be had *)
  write : string -> string -> (unit, string) result;  (** puts these bytes into a file *)
  parameters : (string * Json.t) list;
  (** values and ranges that the command line gives, as [model.load] takes them *)
  start : string;  (** the text to begin with, where there is no file *)
}

val page_data : t -> Json.t
(** What the desk's page begins with. *)

(** What became of saving. *)
type saved =
  | Saved of string  (** the digest of what is in the file now *)
  | Another of { text : string; digest : string }  (** it is another one than the one that was read *)
  | Failed of string

val save : t -> text:string -> over:string option -> saved
(** Writes the text, if the file still has the digest [over], or is still not there ([None]). *)

(** What a client can do, from the params of [initialize]. *)

open Scc_json

(** The abilities of a client that make a difference, and its folders. *)
type t = {
  encoding : Positions.encoding;
  markdown : bool;  (** descriptions may be Markdown *)
  snippets : bool;  (** what completion inserts may have places to be filled in *)
  places : bool;  (** an argument of a call may be told by its place in the form, not by its name *)
  related : bool;  (** diagnostics may have other places *)
  progress : bool;  (** the server may show progress *)
  versioned : bool;  (** changes may name versions of documents *)
  shows : bool;  (** the server may ask to show a page *)
  watches : bool;  (** the server may ask to hear of changed files *)
  fresh_lenses : bool;  (** the server may ask to read lenses again *)
  fresh_values : bool;  (** the server may ask to read values again *)
  folders : string list;  (** paths *)
}

val read : Json.t -> t
(** The abilities in the params of [initialize]. What is missing is not there. *)

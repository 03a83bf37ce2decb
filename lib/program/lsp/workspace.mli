(** The texts of a session: open documents, and files beside them. The text of an open document comes before that
    of its file. *)

open Scc_base
open Scc_syntax
open Scc_describe

(** An open document. Its parts are computed when they are first needed. *)
type document = private {
  uri : string;
  path : string option;  (** of its file *)
  version : int;
  text : string;
  positions : Positions.t Lazy.t;
  reading : Reading.t;
}

type t

val create : Positions.encoding -> t
(** No documents. *)

val encoding : t -> Positions.encoding
(** The encoding of places. *)

val put : t -> uri:string -> version:int -> string -> unit
(** Opens a document, or gives it another text. *)

val remove : t -> string -> unit
(** Closes a document. *)

val find : t -> string -> document option
(** The open document of an address. Addresses of one file are one document. *)

val all : t -> document list
(** The open documents, by their addresses. *)

val text_of : t -> string -> (string, string) result
(** The text of the document or file at a path, or why it cannot be read. Files of more than 64 MiB are not read.
*)

val reading_of : t -> string -> (Reading.t * Positions.t) option
(** The text at a path, as it is read. *)

val reader : t -> document -> string -> (string, string) result
(** The reader of imports and meshes of a document, by their paths as it writes them. *)

val imported : t -> base:string option -> Ast.import -> Reading.t option
(** The text that an import names, in a text whose path is [base]. *)

val resolved : base:string option -> string -> string option
(** The path of a file that a text with the path [base] names. *)

val target : t -> base:string option -> file:string -> (string * Positions.t) option
(** The address of a file named in a diagnostic of a text with the path [base], and its places. [None] for a
    module of the library and for a file that is not there. *)

val place : Positions.t -> Span.t -> Scc_json.Json.t
(** The range of a span in the text of these places. *)

(** The notations of models. Each is read into the syntax tree of [lib/language/syntax], with places in its own
    texts, and is written from such a tree. All later passes are the same for every notation. *)

open Scc_base
open Scc_syntax

type t = {
  name : string;  (** its name on the command line *)
  told : string;  (** a description in a few words *)
  extensions : string list;  (** of its files, with the dot *)
  read : Source.t -> (Ast.model * Trivia.t list, Diag.t list) result;  (** with the comments *)
  write : Ast.model * Trivia.t list -> (string, Diag.t list) result;
  (** in canonical layout, with the comments; the error is what the notation cannot express *)
  canonical : Source.t -> (string, Diag.t list) result;
  (** a text of the notation in canonical layout; {!write} after [read], if reading loses nothing *)
  as_written : Source.t -> (Ast.model * Trivia.t list, Diag.t list) result;
  (** the declarations and comments of a text where they stand in it: of a model that [canonical] can lay out,
      although it may have other errors *)
  readable : Source.t -> Ast.model;  (** what can be read of a text with errors *)
}

val shape_calculus : t
(** The language of [specs/language.md], in files [.sc]. *)

val all : t list
(** The table of all notations; a further notation is a further line of it. *)

val of_source : Source.t -> t
(** The notation of a text, by the extension of its name. With an unknown extension it is XML if the text begins
    with [<], and the language of [specs/language.md] otherwise. *)

val of_name : string -> t option
(** The notation of a file by the extension of its name. *)

val model : Source.t -> (Ast.model, Diag.t list) result
(** Reads a whole model in the notation of {!of_source}. *)

val readable : Source.t -> Ast.model
(** Reads what can be read of a text with errors, in the notation of {!of_source}. *)

val canonical : Source.t -> (string, Diag.t list) result
(** The text in canonical layout, in its own notation ({!of_source}). *)

(** The surface syntaxes in which models are written. Each leads to the syntax tree of [lib/syntax], with the
    places of its own texts, and all that comes after is the same for every one of them. *)

open Scc_base
open Scc_syntax

type t = {
  extensions : string list;  (** of its files, with the dot *)
  model : Source.t -> (Ast.model, Diag.t list) result;
  expression : Source.t -> (Ast.expr, Diag.t list) result;  (** a number or formula alone *)
  canonical : Source.t -> (string, Diag.t list) result;  (** the same model in canonical layout, comments kept *)
}

val all : t list
(** The table: another syntax is another line of it. *)

val of_source : Source.t -> t
(** By the extension of its name. A text without any that is known is in the language of [specs/language.md]. *)

val has_extension : string -> bool
(** Whether the name of a file is that of a model in some syntax. *)

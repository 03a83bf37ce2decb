(** Models from XML, by [specs/bioshape-xml.md]. A document becomes a tree as by [Parse]. Its places are those
    of elements in the document, or of the texts of names and expressions.

    Errors are results, several at a time, at most [Parse.max_errors]. Codes: SC0102, SC0111, SC0350 to SC0353,
    those of [Parse] for the texts, and SC0112 for a document that declares nothing. Stack and memory are
    bounded by the limits of {!Document} and {!Scc_syntax.Tokens}. *)

open Scc_base
open Scc_syntax

val with_trivia : Source.t -> (Ast.model * Trivia.t list, Diag.t list) result
(** Reads a whole document, with its comments as comments of the language. *)

val readable : Source.t -> Ast.model
(** Reads the declarations that can be read of a document with errors, up to the place at which it is no XML. *)

val begins : string -> bool
(** [begins text] is true if the text begins with [<], after spaces at most. No text of the language does. *)

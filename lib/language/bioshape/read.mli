(** Models from XML, as [specs/bioshape-xml.md] tells it. What comes of a document is a tree as {!Parse} makes
    it, with its places in the document: of an element, or of the text that a name or an expression is.

    Errors are results, several at a time, at most {!Parse.max_errors}. Codes: SC0102, SC0111, SC0350 to SC0353,
    those of {!Parse} for the texts, and SC0112 for a document that declares nothing. Stack and memory are
    bounded by the limits of {!Document} and {!Tokens}. *)

open Scc_base
open Scc_syntax

val with_trivia : Source.t -> (Ast.model * Trivia.t list, Diag.t list) result
(** A whole document, with its comments as the language writes them. *)

val readable : Source.t -> Ast.model
(** The declarations that can be read of a document that may have faults, up to where it is no XML. *)

val begins : string -> bool
(** Whether a text begins as XML does, and no text of the language: with [<], after spaces at most. *)

(** Models in XML, as [specs/bioshape-xml.md] tells it: an element for each node of the syntax tree down to
    expressions, features and names, which are texts in the grammar of the language. Two spaces a level; an
    element on one line where it fits in 100 columns. *)

open Scc_base
open Scc_syntax

val model : ?trivia:Trivia.t list -> Ast.model -> (string, Diag.t list) result
(** A whole document, which ends with a line end; reading it gives the same tree ({!Ast_equal}). Comments are put
    back where they stood as {!Printer.model} does it, as comments of XML. SC0354: the name of a file holds what
    XML has no character for. *)

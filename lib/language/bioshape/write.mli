(** Models in XML, by [specs/bioshape-xml.md]. Each node of the syntax tree becomes an element. Expressions,
    features and names become texts in the grammar of the language. Two spaces a level; an element is on one
    line if it fits in 100 columns. *)

open Scc_base
open Scc_syntax

val model : ?trivia:Trivia.t list -> Ast.model -> (string, Diag.t list) result
(** A whole document, which ends with a line end. Reading it gives the same tree, but for places. Comments are
    put back as comments of XML where they stood, as by [Printer.model]. The name of a file with a character
    that XML does not have is SC0354. *)

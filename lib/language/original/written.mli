(** Models of the original notation as texts, in canonical form: ASCII, as {!Scc_syntax.Printer} lays models
    out. *)

open Scc_syntax

val model : trivia:Trivia.t list -> Ast.model -> string
(** Of a tree as {!Tree} tells it. Reading the text gives the same tree, and printing that the same text. *)

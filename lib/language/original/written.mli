(** Models of the original notation as texts in canonical form: ASCII, in the layout of
    {!Scc_syntax.Printer}. *)

open Scc_syntax

val model : trivia:Trivia.t list -> Ast.model -> string
(** The text of a tree of the original notation ({!Tree}). Reading the text gives the same tree, and printing
    that tree the same text. *)

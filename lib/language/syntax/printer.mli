(** Models in canonical form, as [scc fmt] writes them: ASCII, two spaces a level, at most 100 columns where
    the pieces allow it, no more parentheses than needed.

    Reading back what is printed gives the same tree ({!Ast_equal}), and printing that the same text. *)

val model : ?trivia:Trivia.t list -> Ast.model -> string
(** Ends with a line end. [trivia] (default: none), from {!Parse.with_trivia} of the text that the tree came
    from, are put back: every comment, and between declarations one empty line where there were any. *)

val expr : Ast.expr -> string
(** A number or formula on one line. *)

val head : Ast.head -> string
(** [Brick(a, b)]. *)

val behaviour : Ast.behaviour -> string
(** On one line. *)

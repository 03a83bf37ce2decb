(** Models in canonical form, as [scc fmt] writes them: ASCII, two spaces a level, at most 100 columns where
    the pieces allow it, no more parentheses than needed.

    Reading back what is printed gives the same tree, but for places, and printing that the same text. *)

val model : ?trivia:Trivia.t list -> Ast.model -> string
(** [model items] is the text of a model and ends with a line end. [trivia] (default: none) are comments and
    empty lines by {!Parse.with_trivia} of the text of the tree. Every comment is put back, and between
    declarations one empty line if there were any. *)

val expr : Ast.expr -> string
(** [expr e] is a number or formula on one line. *)

val head : Ast.head -> string
(** [head h] is the left side of a declaration, such as [Brick(a, b)]. *)

val behaviour : Ast.behaviour -> string
(** [behaviour b] is a behaviour on one line. *)

(** Equality of syntax trees up to their places in the text. *)

val expr : Ast.expr -> Ast.expr -> bool
val behaviour : Ast.behaviour -> Ast.behaviour -> bool
val item : Ast.item -> Ast.item -> bool
val model : Ast.model -> Ast.model -> bool

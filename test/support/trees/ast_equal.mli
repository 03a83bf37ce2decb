(** Equality of syntax trees. Places in the text are ignored; numbers compare by value. *)

open Scc_syntax

val expr : Ast.expr -> Ast.expr -> bool
(** [expr a b] is true if the two expressions are equal up to their places. *)

val model : Ast.model -> Ast.model -> bool
(** [model a b] is true if the two models have equal declarations in the same order, up to their places. *)

(** Expressions as reports show them, with the values of loop variables. A check about [m[i + 1]] that a loop
    makes for i = 2 is shown with [m[3]]. *)

open Scc_syntax

val expr : Env.t -> string list -> Ast.expr -> Ast.expr
(** [expr env names e] replaces the loop variables [names] in [e] by their values. Indices that contain one are
    evaluated. *)

(** Expressions as reports show them: with the values of the loops that they stand in, so that the check about
    [m[i + 1]] that a loop makes for i = 2 speaks of [m[3]]. *)

open Scc_syntax

val expr : Env.t -> string list -> Ast.expr -> Ast.expr
(** The values of these loop variables put in for their names, and indices that mention one worked out. *)

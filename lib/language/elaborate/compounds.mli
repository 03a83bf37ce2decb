(** Compound shapes (Definition 4.5): parts that are glued into a tree at the highest pair of features, move
    as one and do not interpenetrate. *)

open Scc_syntax

val declare : Context.t -> Env.t -> Ast.head -> Ast.part list -> Ast.glue list -> Ast.definitions -> unit

(** Random syntax trees: any that the parser can build, and no other. Places are {!Scc_base.Span.none}. *)

val expr : Scc_syntax.Ast.expr QCheck2.Gen.t
val operators : Scc_syntax.Ast.expr QCheck2.Gen.t
(** Operators over operators, to test precedence. *)

val model : Scc_syntax.Ast.model QCheck2.Gen.t

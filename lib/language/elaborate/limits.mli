(** The stated limits of models: a text beyond one is refused (SC0111) before it is worked on. *)

open Scc_syntax

val depth : int
(** Expressions, behaviours, solids and loops nest at most so deep: 10 000. *)

val operators : int
(** Operators of time nest at most so deep, with their [let]s: 1 000. *)

val items : int
(** Declarations after the expansion of loops: 1 000 000. *)

val terms : int
(** Nodes of the laws and formulas of a model, after the expansion of quantifiers and [let]: 4 000 000. *)

val number_bits : int
(** Bits of a constant, numerator and denominator together: 1 000 000. *)

val exists_in : (Ast.expr -> bool) -> Ast.expr -> bool
(** Whether the expression, or one inside it, satisfies the predicate. *)

val check_depth : Report.t -> Ast.model -> unit
(** Reports the declarations that nest too deeply. All the other passes recur on the syntax tree, and rely
    on this. *)

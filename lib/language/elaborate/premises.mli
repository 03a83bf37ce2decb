(** The premises of a check: the left sides of [=>] directly below [always], and of [leads_to]. A check whose
    premise never holds is vacuous. *)

open Scc_syntax

val of_check : Ast.expr -> (Ast.expr * Ast.expr) list
(** Each premise f as written, with the formula [possibly f], which says that some run meets it within the bound
    of its [always]. Below [forall p in T] the formula says that some p of T meets it. Premises inside a [let],
    or below other operators, are not found. *)

(** What has to come true for a check to say anything: the left sides of [=>] right below [always], and of
    [leads_to]. *)

open Scc_syntax

val of_check : Ast.expr -> (Ast.expr * Ast.expr) list
(** Each premise f, as it is written, with a formula that says that some run ever meets it, within the bound of
    its [always]: [possibly f]. Below [forall p in T], that some p of T meets it. Premises behind the name of a
    [let] are not looked for, nor are those below another operator. *)

(** Laws of motion: vectors of expressions over the variables that rule Steer gives them (reading I-10). A
    declared value hides a variable of the same name. *)

open Scc_syntax
open Scc_calculus

val law : Report.t -> Typed.budget -> Env.t -> Ast.law -> Law.t option
(** [choose] is SC0901. *)

(** Laws of motion: vectors of expressions over the variables that rule Steer gives them (reading I-10). A
    declared value hides a variable of the same name. *)

open Scc_exact
open Scc_syntax
open Scc_calculus

val words : string list
(** The variables of laws, by their names. *)

val functions : string list
(** What is called as a function, and gives a whole law. *)

val can_read : Typed.budget -> Env.t -> Ast.expr -> bool
(** Whether an expression makes sense in a law. *)

val check : Report.t -> Typed.budget -> Env.t -> Ast.expr -> unit
(** Reports what is wrong with an expression as a part of a law. *)

val speaks_of_a_law : Env.t -> Ast.expr -> bool
(** Whether an expression has a variable that only laws have. *)

val law : Report.t -> Typed.budget -> timestep:Rat.t -> Env.t -> Ast.law -> Law.t option
(** SC0601 for a choice of nothing, and for a weight that is negative whatever the state. *)

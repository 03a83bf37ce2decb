(** Laws of motion: vectors of expressions over the variables that rule Steer provides (reading I-10). A
    declared value hides a variable of the same name. *)

open Scc_exact
open Scc_syntax
open Scc_calculus

val words : string list
(** The names of the variables of laws. *)

val functions : string list
(** The functions that give a whole law: [diffuse]. *)

val can_read : Typed.budget -> Env.t -> Ast.expr -> bool
(** [can_read budget env e] is true if [e] makes sense in a law. It spends the budget and reports nothing. *)

val check : Report.t -> Typed.budget -> Env.t -> Ast.expr -> unit
(** Reports the faults of an expression as a part of a law. *)

val speaks_of_a_law : Env.t -> Ast.expr -> bool
(** [speaks_of_a_law env e] is true if [e] has a variable that only laws have. [time] is none, since formulas
    have it too. *)

val some_diffuse : Ast.model -> bool
(** [some_diffuse m] is true if some law of [m] is [diffuse]. *)

val law :
  Report.t -> Typed.budget -> timestep:Rat.t -> Env.t -> Ast.law -> (Law.t * Diffusion.lattice option) option
(** Elaborates a law, with the lattice of [diffuse]. A choice without velocities, or with weights that are all 0,
    is SC0601. So is a weight that is negative in every state. *)

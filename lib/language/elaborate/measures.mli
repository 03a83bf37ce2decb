(** Probabilities and means in properties: [P >= 1/2 [ f U g ]], [Pmax = ? [ eventually f ]], [E = ? [ x(p) at 10
    ]]. *)

open Scc_syntax
open Scc_property

(** How expressions are read in their scope. Each function reports what is wrong. *)
type reader = {
  report : Report.t;
  env : Env.t;
  formula : Ast.expr -> Property.temporal option;
  bound : Ast.bound option -> Property.bound option;
  value : Ast.expr -> (Property.num, Property.temporal) Typed.value option;
}

val words : string list
(** The words that may stand before the bracket: [P], [Pmin], [Pmax], [E], [Emin] and [Emax]. *)

val is_question : Ast.expr -> (Ast.binary * Ast.expr) option -> bool
(** [is_question m test] is true if the measure must be a whole check: it requests a number, or it compares a
    mean. *)

val formula :
  reader -> Scc_base.Span.t -> Ast.expr -> (Ast.binary * Ast.expr) option -> Ast.outcome -> Property.temporal
    option
(** The formula of a probability that is compared with a number from 0 to 1. Any other measure is SC0701. *)

val question :
  reader ->
  Ast.expr ->
  (Ast.binary * Ast.expr) option ->
  Ast.outcome ->
  (Property.asked * Property.temporal) option
(** The question of a measure that is a whole check, and the formula of its runs. [E = ? [x(p) at 10]] is an
    example. *)

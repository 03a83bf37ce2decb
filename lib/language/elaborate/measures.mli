(** Probabilities and means in properties: [P >= 1/2 [ f U g ]], [Pmax = ? [ eventually f ]], [E = ? [ x(p) at 10
    ]]. *)

open Scc_syntax
open Scc_property

(** How expressions are read where they stand. Each of these reports what is wrong. *)
type reader = {
  report : Report.t;
  env : Env.t;
  formula : Ast.expr -> Property.temporal option;
  bound : Ast.bound option -> Property.bound option;
  value : Ast.expr -> (Property.num, Property.temporal) Typed.value option;
}

val words : string list
(** What may stand before the bracket: [P], [Emin], ... *)

val is_question : Ast.expr -> (Ast.binary * Ast.expr) option -> bool
(** Whether only a check by itself can say it: what asks for a number, and what compares a mean. *)

val formula :
  reader -> Scc_base.Span.t -> Ast.expr -> (Ast.binary * Ast.expr) option -> Ast.outcome -> Property.temporal
    option
(** Of a probability that is compared. *)

val question :
  reader ->
  Ast.expr ->
  (Ast.binary * Ast.expr) option ->
  Ast.outcome ->
  (Property.asked * Property.temporal) option

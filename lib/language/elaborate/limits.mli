(** The limits of models. A text beyond a limit is refused (SC0111) before it is worked on. *)

open Scc_syntax

val depth : int
(** The greatest depth of nested expressions, behaviours, solids and loops: 10 000. *)

val operators : int
(** The greatest depth of nested temporal operators, with their [let]s: 1 000. *)

val items : int
(** The greatest number of declarations after the expansion of loops: 1 000 000. *)

val terms : int
(** The greatest number of nodes in the laws and formulas of a model, after the expansion of quantifiers and
    [let]: 4 000 000. *)

val number_bits : int
(** The greatest size of a constant in bits, numerator and denominator together: 1 000 000. *)

val exists_in : (Ast.expr -> bool) -> Ast.expr -> bool
(** [exists_in p e] is true if [e], or an expression inside it, satisfies [p]. *)

(** A part of a syntax tree. *)
type node =
  | Expr of Ast.expr
  | Solid of Ast.solid
  | Behaviour of Ast.behaviour
  | Item of Ast.item

val children : node -> node list
(** The parts directly below a part, in any order. *)

val check_depth : Report.t -> Ast.model -> unit
(** Reports declarations that nest too deeply. All other passes recurse on the syntax tree, so they need this
    check first. *)

(** Expressions whose value the text determines: attributes, steps, indices, delays, bounds. Each function
    reports what it cannot evaluate and then gives [None].

    A value that depends on a parameter with a known range is refused (SC0218), with the reason [why] if it is
    given. Only {!form}, {!value} and {!transform} accept such values. *)

open Scc_base
open Scc_exact
open Scc_syntax

val of_state : string list
(** The functions of properties, whose values depend on the state. *)

val of_shapes : string
(** The reason, for SC0218, that shapes cannot depend on parameters with ranges. *)

val truth : ?why:string -> Report.t -> Env.t -> Ast.expr -> bool option
(** The truth value of a constant expression. [why] is the reason in SC0218 (default: that a constant is
    expected). *)

val is_constant : Env.t -> Ast.expr -> bool
(** [is_constant env e] is true if [e] consists of numbers, truth values, constants in scope and operations on
    them. *)

val is_open : Env.t -> Ast.expr -> bool
(** [is_open env e] is true if [e] depends on a parameter that is [Unknown]. It is also true if more than 10 000
    expressions would have to be searched. *)

val value : Report.t -> Env.t -> Ast.expr -> Env.value option
(** The value as a [Number], [Truth], [Vector] or [Affine]. *)

val number : ?why:string -> Report.t -> Env.t -> Ast.expr -> Rat.t option
(** The value of a constant number. *)

(** A number that is known, or that is a function of the parameter of [--parametric]. *)
type odds = Known of Rat.t | Open of Scc_calculus.Open_number.t

val odds : why:string -> Report.t -> Env.t -> Ast.expr -> odds option
(** A number of a chance. *)

val form : Report.t -> Env.t -> Ast.expr -> Form.t option
(** A number that may depend on parameters with known ranges. *)

val positive : ?why:string -> Report.t -> Env.t -> string -> Ast.expr -> Rat.t option
(** [positive report env what e] is a constant greater than zero (SC0208 otherwise). [what] names the quantity
    in the message. *)

val integer : ?why:string -> Report.t -> Env.t -> string -> Ast.expr -> Z.t option
(** [integer report env what e] is a constant integer (SC0204 otherwise). [what] names the quantity in the
    message. *)

val index : Report.t -> Env.t -> Ast.expr -> Z.t option
(** The constant integer that is an index of a name (SC0204 otherwise). *)

val vector : ?why:string -> Report.t -> Env.t -> Ast.vector -> Vec.t option
(** The value of a constant vector. *)

val corner : Report.t -> Env.t -> Ast.vector -> Vec.t option
(** The point of a corner of a shape, in the frame of the shape; its components must be constants. *)

val transform : Report.t -> Env.t -> Ast.transform list -> Placement.t option
(** The map [T1 * T2 * …], of which the last is applied first. Only its translation may depend on ranges. Each
    factor has a positive determinant (SC0311 otherwise). *)

val scaling : Report.t -> Env.t -> Span.t -> Ast.vector -> Vec.t option
(** Factors along the three axes, with a positive product (SC0311 otherwise). *)

val segment : Report.t -> Env.t -> Ast.segment -> string option
(** A name with its indices as it is printed: [c[3]], [g[1,2]]. *)

(** Expressions whose value the text determines: attributes, steps, indices, delays, bounds. All functions
    report what they cannot evaluate and then give [None]. What depends on parameters of which ranges are known is
    refused (SC0218), with the reason [why] where one is given, but by {!form}, {!place}, {!value} and
    {!transform}. *)

open Scc_base
open Scc_exact
open Scc_syntax

val of_state : string list
(** The functions of properties, which are no constants. *)

val of_shapes : string
(** Why shapes cannot depend on such parameters. *)

val truth : ?why:string -> Report.t -> Env.t -> Ast.expr -> bool option

val is_constant : Env.t -> Ast.expr -> bool
(** Only numbers, truth values, constants in scope and operations on them. *)

val is_open : Env.t -> Ast.expr -> bool
(** It depends on a parameter that is [Unknown]. True as well of what is too large to find out. *)

val value : Report.t -> Env.t -> Ast.expr -> Env.value option
(** A [Number], [Truth], [Vector] or [Affine]. *)

val number : ?why:string -> Report.t -> Env.t -> Ast.expr -> Rat.t option

val form : Report.t -> Env.t -> Ast.expr -> Form.t option
(** A number that may depend on parameters of which ranges are known. *)

val positive : ?why:string -> Report.t -> Env.t -> string -> Ast.expr -> Rat.t option
(** The string names the quantity in the message. *)

val integer : ?why:string -> Report.t -> Env.t -> string -> Ast.expr -> Z.t option
val index : Report.t -> Env.t -> Ast.expr -> Z.t option
val vector : ?why:string -> Report.t -> Env.t -> Ast.vector -> Vec.t option

val corner : Report.t -> Env.t -> Ast.vector -> Vec.t option
(** Of a shape. *)

val place : Report.t -> Env.t -> Ast.vector -> Form.place option
(** A vector whose components may depend on such parameters. *)

val transform : Report.t -> Env.t -> Ast.transform list -> Placement.t option
(** [T1 * T2 * …]: the last is applied first. Each has a positive determinant (SC0311 otherwise). *)

val scaling : Report.t -> Env.t -> Span.t -> Ast.vector -> Vec.t option
(** Factors for the three axes, with a positive product (SC0311 otherwise). *)

val segment : Report.t -> Env.t -> Ast.segment -> string option
(** A name with its indices, as it is printed: [c[3]], [g[1,2]]. *)

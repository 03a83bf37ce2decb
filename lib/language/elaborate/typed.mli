(** Expressions are one syntax with several meanings: constants, laws of motion, formulas. Each meaning is an
    {!ALGEBRA}; what they share (scopes, types, folding of constants, exact arithmetic and its limits) is
    {!Make}. *)

open Scc_base
open Scc_syntax

type ('n, 'c) value = ('n, 'c) Algebra.value = Num of 'n | Cond of 'c | Vec of 'n * 'n * 'n
type budget = Algebra.budget = { mutable left : int; mutable spent_on : Span.t }

val budget : unit -> budget
(** Of {!Limits.terms}. *)

module type ALGEBRA = Algebra.S

module Make (A : ALGEBRA) : sig
  val eval : A.context -> Env.t -> Ast.expr -> (A.num, A.cond) value option
  val num : A.context -> Env.t -> Ast.expr -> A.num option
  val cond : A.context -> Env.t -> Ast.expr -> A.cond option

  val vec : A.context -> Env.t -> Ast.expr -> (A.num * A.num * A.num) option

  val as_num : A.context -> Span.t -> (A.num, A.cond) value option -> A.num option
  (** Reports a type error at the span. *)

  val as_cond : A.context -> Span.t -> (A.num, A.cond) value option -> A.cond option
end

val functions : string list
(** The functions of numbers and vectors that every algebra has. *)

val described : ('n, 'c) value -> string
(** "a number", "a vector", "a truth value". *)

val unknown_function : Report.t -> Ast.name -> string list -> unit
(** Reports a function that is not among these, and lists them. *)

val both : 'a option -> 'b option -> ('a * 'b) option

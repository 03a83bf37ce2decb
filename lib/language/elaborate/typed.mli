(** Expressions are one syntax with several meanings: constants, laws of motion, formulas. Each meaning is an
    {!ALGEBRA}. {!Make} has what they share: scopes, types, folding of constants, exact arithmetic and its
    limits. *)

open Scc_base
open Scc_syntax

type ('n, 'c) value = ('n, 'c) Algebra.value = Num of 'n | Cond of 'c | Vec of 'n * 'n * 'n
type budget = Algebra.budget = { mutable left : int; mutable spent_on : Span.t }

val budget : unit -> budget
(** A fresh budget of {!Limits.terms} terms. *)

module type ALGEBRA = Algebra.S

module Make (A : ALGEBRA) : sig
  val eval : A.context -> Env.t -> Ast.expr -> (A.num, A.cond) value option
  (** The value of an expression. Faults are reported and give [None]. *)

  val num : A.context -> Env.t -> Ast.expr -> A.num option
  (** The value of an expression that is a number (SC0205 otherwise). *)

  val cond : A.context -> Env.t -> Ast.expr -> A.cond option
  (** The value of an expression that is a truth value (SC0205 otherwise). *)

  val vec : A.context -> Env.t -> Ast.expr -> (A.num * A.num * A.num) option
  (** The components of an expression that is a vector (SC0205 otherwise). *)
end

val functions : string list
(** The functions of numbers and vectors that every algebra has, in alphabetical order. *)

val without_brackets : string list -> string -> string option
(** [without_brackets functions name] is the hint for a name that is not known, if it is one of these functions. *)

val described : ('n, 'c) value -> string
(** The kind of a value as a text: ["a number"], ["a vector"] or ["a truth value"]. *)

val unknown_function : Report.t -> Ast.name -> string list -> unit
(** [unknown_function report f known] reports an unknown function (SC0201). The message lists [known],
    sorted. *)

val both : 'a option -> 'b option -> ('a * 'b) option
(** [both a b] is the pair of two results, or [None] if one is [None]. *)

(** Expressions are one syntax with several meanings: constants, laws of motion, formulas. Each meaning is an
    {!ALGEBRA}; what they share (scopes, types, folding of constants, exact arithmetic and its limits) is
    {!Make}. *)

open Scc_base
open Scc_exact
open Scc_syntax
open Scc_calculus

type ('n, 'c) value = Num of 'n | Cond of 'c

(** How many terms may still be made, and for which expression they are. *)
type budget = { mutable left : int; mutable spent_on : Span.t }

val budget : unit -> budget
(** Of {!Limits.terms}. *)

module type ALGEBRA = sig
  type context
  type num
  type cond

  val report : context -> Report.t
  val budget : context -> budget
  val const : Rat.t -> num
  val constant : num -> Rat.t option
  val neg : num -> num
  val add : num -> num -> num
  val sub : num -> num -> num
  val mul : num -> num -> num

  val div : num -> num -> num
  (** The divisor is not the constant zero. *)

  val bool : bool -> cond
  val truth : cond -> bool option
  val compare : Law.comparison -> num -> num -> cond
  val negate : cond -> cond
  val conj : cond -> cond -> cond
  val disj : cond -> cond -> cond

  val choose : context -> Span.t -> cond -> num -> num -> num option
  (** [if] between numbers; the span is the condition's. *)

  val choose_cond : cond -> cond -> cond -> cond

  val variable : context -> Env.t -> Ast.path -> (num, cond) value option
  (** A name that the scope does not bind; [None] when it was reported. *)

  val comparison :
    context -> Env.t -> Ast.binary -> Ast.expr -> Ast.expr -> (num, cond) value option option
  (** A comparison of things that are no numbers; [None] when it is an ordinary one. *)

  val other :
    context ->
    (Env.t -> Ast.expr -> (num, cond) value option) ->
    Env.t ->
    Ast.expr ->
    (num, cond) value option
    (** [Apply], [Co], [Quantified], [Temporal], [Until], [Leads_to], [Event]; the function elaborates a part. *)
end

module Make (A : ALGEBRA) : sig
  val eval : A.context -> Env.t -> Ast.expr -> (A.num, A.cond) value option
  val num : A.context -> Env.t -> Ast.expr -> A.num option
  val cond : A.context -> Env.t -> Ast.expr -> A.cond option

  val as_num : A.context -> Span.t -> (A.num, A.cond) value option -> A.num option
  (** Reports a type error at the span. *)

  val as_cond : A.context -> Span.t -> (A.num, A.cond) value option -> A.cond option
end

val both : 'a option -> 'b option -> ('a * 'b) option

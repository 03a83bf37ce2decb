(** What an expression can mean: an algebra of numbers and truth values ({!Typed}). *)

open Scc_base
open Scc_exact
open Scc_syntax
open Scc_calculus

type ('n, 'c) value = Num of 'n | Cond of 'c | Vec of 'n * 'n * 'n

(** How many terms may still be made, and for which expression they are. *)
type budget = { mutable left : int; mutable spent_on : Span.t }

module type S = sig
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

  val admits : context -> Span.t -> Ast.binary -> num -> num -> bool
  (** Whether there is a term for this operation on numbers that are not both constants; false when it was
      reported. *)

  val affine : context -> Span.t -> Form.t -> num option
  (** What depends on parameters of which ranges are known; [None] when it was reported. *)

  val open_number : context -> Span.t -> Open_number.t -> num option
  (** What is a function of the one parameter that is asked about; [None] when it was reported. *)

  val bool : bool -> cond
  val truth : cond -> bool option
  val compare : Law.comparison -> num -> num -> cond
  val negate : cond -> cond
  val conj : cond -> cond -> cond
  val disj : cond -> cond -> cond

  val choose : context -> Span.t -> cond -> num -> num -> num option
  (** [if] between numbers; the span is the condition's. *)

  val choose_cond : cond -> cond -> cond -> cond

  val nearest : context -> Span.t -> string -> num -> num option
  (** The integer nearest to a number that is no constant, the one farther from zero if there are two; [None]
      where there is no term for it, which is reported: the string names the function that asks. *)

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
    (** [Apply], [Apply_in], [Co], [Quantified], [Temporal], [Until], [Leads_to], [Event]; the function elaborates
        a part. *)
end


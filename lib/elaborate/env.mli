(** What names of values stand for at a place of the text: parameters, loop variables, [let]s, and the
    variables of quantifiers. Scopes are lexical: a name may be used after its declaration, and an inner one
    hides an outer one. *)

open Scc_base
open Scc_exact
open Scc_syntax

type t

type value =
  | Number of Rat.t
  | Truth of bool
  | Macro of Ast.expr * t  (** a [let] that is no constant, with the scope of its declaration *)
  | Leaf of int  (** a process variable of a quantifier: an index into {!Scc_calculus.Model.leaves} *)

type binding = { value : value; span : Span.t; mutable used : bool }

val empty : t
val add : string -> binding -> t -> t

val find : t -> string -> value option
(** Marks the binding as used. *)

val names : t -> string list

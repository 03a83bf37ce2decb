(** Numbers that a text says plainly: literals, values of earlier [let]s that are such, and what [+], [-], [*] and [/]
    make of them. (Parameters are not: another value may be given to them when a model is run.) *)

open Scc_base
open Scc_exact
open Scc_syntax

type t

val none : t
val add : t -> Ast.item -> t
(** What a declaration adds: a [let]. *)

val number : t -> Ast.expr -> (Rat.t, Span.t) result
(** The error is the place of what is no plain number. *)

val vector : t -> Ast.expr -> (Vec.t, Span.t) result

(** Numbers that a text says plainly: literals, values of earlier [let]s that are such, and what [+], [-], [*]
    and [/] make of them. (Parameters are not: another value may be given to them when a model is run.) *)

open Scc_base
open Scc_exact
open Scc_syntax

type t

val none : t

val of_model : Ast.model -> t
(** The constants that a text declares; not those whose names stand for something else somewhere in it, as a
    parameter of a shape or behaviour, a value of its own, the index of a loop or a [let] in one: there these
    are meant. *)

val number : t -> Ast.expr -> (Rat.t, Span.t) result
(** The error is the place of what is no plain number. *)

val vector : t -> Ast.expr -> (Vec.t, Span.t) result

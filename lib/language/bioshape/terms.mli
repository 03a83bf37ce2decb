(** The terms of the calculus as elements: features, behaviours, shapes and placements. Each function takes the
    elements that it reads; a missing one is reported (SC0353). *)

open Scc_syntax

val feature : Content.t -> Ast.feature
(** Takes the next element, a [<feature>]. *)

val behaviour : Content.t -> Ast.behaviour
(** Takes the elements of a behaviour: prefixes, then [<nil>], [<call>] or [<choice>]. A behaviour nested too
    deeply is SC0111. *)

val solid : Content.t -> Ast.solid
(** Takes the elements of a solid: one that is a solid, then any number of [<scaled>]. *)

val attributes : Content.t -> Ast.attribute list
(** Takes any number of [<mass>], [<velocity>], [<spin>], [<absorb>] and [<at>], in any order. *)

(** The terms of the calculus as elements: features, behaviours, shapes and where they are. *)

open Scc_syntax

val feature : Content.t -> Ast.feature
(** The next element, which is a [<feature>]. *)

val behaviour : Content.t -> Ast.behaviour
(** The elements that come next: prefixes, then [<nil>], [<call>] or [<choice>]. *)

val solid : Content.t -> Ast.solid
(** The elements that come next: one that is a solid, then any [<scaled>]. *)

val attributes : Content.t -> Ast.attribute list
(** [<mass>], [<velocity>], [<spin>], [<absorb>], [<at>], in any order. *)

val reference : Ast.name -> Ast.reference
(** By that name alone. *)

(** The atoms of formulas: numbers and predicates of an instant, and the transitions that lead to it. Each
    function reports what is wrong and then returns [None]. *)

open Scc_base
open Scc_syntax
open Scc_property

type value := (Property.num, Property.temporal) Typed.value option

val words : string list
(** The names of the numbers and predicates of formulas. *)

val transitions : string list
(** The words that may follow [event]. *)

val apply : Subjects.t -> Env.t -> Ast.expr -> Ast.name -> Ast.expr list -> value
(** [apply s env e f arguments] is the atom of an application [e], such as [x(p)] or [bonds(a, p, q)]. *)

val event : Subjects.t -> Env.t -> Span.t -> Ast.name -> Ast.expr list -> value
(** [event s env at word arguments] is the atom of a transition, such as [event bind(a, p, q)], which stands at
    [at]. *)

val variable : Subjects.t -> Env.t -> Ast.path -> value
(** [variable s env path] is the atom of a name that the scope does not bind, such as [energy] or
    [momentum.x]. *)

val comparison : Subjects.t -> Env.t -> Ast.binary -> Ast.expr -> Ast.expr -> value option
(** [comparison s env op a b] is the atom of [behaviour(p) = K], in either order. It is [None] for a comparison
    of numbers. *)

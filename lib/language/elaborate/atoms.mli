(** The atoms of formulas: numbers and predicates about the instant, and the transitions that may have led to
    it. Each function reports what is wrong, and returns [None] then. *)

open Scc_base
open Scc_syntax
open Scc_property

type value := (Property.num, Property.temporal) Typed.value option

val words : string list
(** The numbers and predicates of formulas, by their names. *)

val transitions : string list
(** What [event] may be followed by. *)

val apply : Subjects.t -> Env.t -> Ast.expr -> Ast.name -> Ast.expr list -> value
(** [x(p)], [bonds(a, p, q)]: an application, its function and its arguments. *)

val event : Subjects.t -> Env.t -> Span.t -> Ast.name -> Ast.expr list -> value
(** [event bind(a, p, q)]: where it stands, the transition's word and the arguments. *)

val variable : Subjects.t -> Env.t -> Ast.path -> value
(** [energy], [momentum.x]: a name that the scope does not bind. *)

val comparison : Subjects.t -> Env.t -> Ast.binary -> Ast.expr -> Ast.expr -> value option
(** [behaviour(p) = K], either way round; [None] when it is a comparison of numbers. *)

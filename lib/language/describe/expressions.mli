(** The names in numbers, vectors, formulas and laws: each is told to the {!Scope}. *)

open Scc_syntax

(** As what the first name of a path is looked up. *)
type role =
  | Number  (** or whatever else it may be *)
  | Body
  | Over  (** what a quantifier ranges over *)
  | Kind  (** what a behaviour is compared with *)

val expr : Scope.t -> Scope.context -> Ast.expr -> unit
val path : Scope.t -> Scope.context -> role -> Ast.path -> unit
val segments : Scope.t -> Scope.context -> Ast.segment list -> unit

val follow : Scope.t -> Scope.meaning -> Ast.segment list -> unit
(** What comes after a name and a dot. *)

val bounds : Scope.t -> Scope.context -> Ast.bounds -> Scope.context -> unit
(** The ends, and in the second context the condition. *)

val index : Ast.name -> start:int -> Ast.bounds -> Declared.t
(** The variable of a loop, or of a quantifier over integers, which begins there. *)

val of_module : Scope.t -> Ast.name -> Ast.name -> unit
(** [m.K]. *)

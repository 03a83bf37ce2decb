(** The names in numbers, vectors, formulas and laws. Each is entered in the {!Scope}. *)

open Scc_syntax

(** The kind of thing for which the first name of a path is looked up. *)
type role =
  | Number  (** or anything else *)
  | Body
  | Over  (** the range of a quantifier *)
  | Kind  (** the other side of a comparison with a behaviour *)

val expr : Scope.t -> Scope.context -> Ast.expr -> unit
(** Enters the names of an expression. *)

val path : Scope.t -> Scope.context -> role -> Ast.path -> unit
(** Enters the names of a path and of its indices. Its first name is looked up by the role. *)

val segments : Scope.t -> Scope.context -> Ast.segment list -> unit
(** Enters the names in the indices of a path. *)

val follow : Scope.t -> Scope.meaning -> Ast.segment list -> unit
(** [follow t m rest] enters the names [rest] that follow a name with the meaning [m] after a dot. *)

val bounds : Scope.t -> Scope.context -> Ast.bounds -> Scope.context -> unit
(** [bounds t c b inner] enters the names of a range: those of its ends in [c], and those of its condition in
    [inner]. *)

val index : Ast.name -> start:int -> Ast.bounds -> Declared.t
(** [index v ~start b] is the declaration of the variable of a loop, or of a quantifier over integers. Its place
    begins at [start]. *)

val of_module : Scope.t -> Ast.name -> Ast.name -> unit
(** [of_module t m k] enters the names of [m.k], where [m] is an import. *)

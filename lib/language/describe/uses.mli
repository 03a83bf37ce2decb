(** Where names stand in a text, and what each means there. Nothing is worked out, so that texts full of faults
    will do. *)

open Scc_syntax

type t = Scope.t

val of_model : Declared.all -> Ast.model -> t

val all : t -> Scope.use list
(** In no particular order. *)

val at : t -> int -> Scope.use option
(** The use whose name begins at an offset. *)

val channel : t -> string -> Scope.channel_use list
(** In the order of the text. *)

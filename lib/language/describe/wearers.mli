(** Which solids have a behaviour: those of the bodies that begin with it, or with one that leads to it. *)

open Scc_syntax

(** The solids of all behaviours of a text. *)
type t

val of_model : Ast.model -> t
(** The solids of the behaviours of a text, with those in loops. *)

val solids : t -> string -> Ast.solid list
(** The solids that have the behaviour of this name, each once, at most eight. *)

val iter : t -> (string -> Ast.solid list -> unit) -> unit
(** Calls a function with each behaviour that a body leads to, and its solids. *)

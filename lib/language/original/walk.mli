(** Changes of a tree at the places where the original notation differs. *)

open Scc_syntax

type t = {
  channel : Ast.channel -> Ast.channel;
  feature : Ast.feature -> Ast.feature;  (** of bonds and glues *)
  solid : Ast.solid -> Ast.solid;  (** a whole one, what is scaled in it included *)
}

val same : t
(** Nothing. *)

val behaviour : t -> Ast.behaviour -> Ast.behaviour
(** Any number of prefixes and summands. *)

val leaf : t -> Ast.leaf -> Ast.leaf
val bond : t -> Ast.bond -> Ast.bond

val item : t -> Ast.item -> Ast.item
(** The items in a loop as well. *)

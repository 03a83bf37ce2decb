(** Changes of a tree at the places at which the original notation differs. *)

open Scc_syntax

(** A change of channels, features and solids. *)
type t = {
  channel : Ast.channel -> Ast.channel;
  feature : Ast.feature -> Ast.feature;  (** of bonds and glues *)
  solid : Ast.solid -> Ast.solid;  (** a whole one, what is scaled in it included *)
}

val same : t
(** The identity: it changes nothing. *)

val behaviour : t -> Ast.behaviour -> Ast.behaviour
(** Changes the channels of a behaviour, in all its prefixes and summands. *)

val bond : t -> Ast.bond -> Ast.bond
(** Changes the two features of a bond. *)

val item : t -> Ast.item -> Ast.item
(** Changes all parts of a declaration, and the declarations in a loop. *)

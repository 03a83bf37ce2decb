(** Pieces of the language that stand in the text of another notation: a name, a feature or an expression in an
    attribute of XML, say. They are read by the grammar of the language itself, each as a whole, and have their
    places, and those of what is wrong with them, in the text that they stand in.

    The codes are those of {!Parse}; SC0110 for what is something else than is asked for. *)

open Scc_base

type t = {
  source : Source.t;  (** what the piece stands in *)
  text : string;  (** the piece itself *)
  place : int -> int;  (** where each of its bytes stands there, and, for its length, where it ends *)
}

type 'a read = t -> ('a, Diag.t list) result

val span : t -> Span.t
val expression : Ast.expr read
val name : Ast.name read

val word : Ast.name read
(** A name that is no word of the language: what a setting is set to. *)

val rounded : Ast.name read
(** What [round] is said of: such a word, or [velocity]. *)

val path : Ast.path read
val segment : Ast.segment read
val feature : Ast.feature read

val member : only:bool -> Ast.member read
(** A feature as one of an active surface; [only] is no part of the piece. *)

val template : Ast.reference read
val behaviour : Ast.reference read

val head : Ast.head read
(** [K], [K[i, 0]], [K(a, b)]: what a behaviour is declared as. *)

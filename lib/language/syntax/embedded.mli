(** Pieces of the language within the text of another notation, such as a name, a feature or an expression in an
    attribute of XML. Each piece is read as a whole by the grammar of the language. Places of trees and of
    errors are places in the text around the piece.

    Codes: those of {!Parse}, and SC0110 if the piece is something else than the reader expects. *)

open Scc_base

type t = {
  source : Source.t;  (** the text around the piece *)
  text : string;  (** the piece itself *)
  place : int -> int;  (** from an offset in [text] to one in [source]; the length of [text] gives the end *)
}

type 'a read = t -> ('a, Diag.t list) result
(** A reader of pieces of one kind. An error lists all that is wrong with the piece. *)

val span : t -> Span.t
(** [span e] is the place of the piece in [e.source]. *)

val expression : Ast.expr read
(** Reads a number, vector, truth value, law or formula. *)

val name : Ast.name read
(** Reads a name that is no word of the language, such as [cube]. *)

val word : Ast.name read
(** Reads one word to which a setting is set, such as [free_body]. *)

val rounded : Ast.name read
(** Reads what [round] is applied to: [orientation] or [velocity]. Any other name is left to elaboration. *)

val path : Ast.path read
(** Reads a path, such as [p], [c[i, j]] or [c[i].left]. *)

val segment : Ast.segment read
(** Reads a path of one segment: a name, perhaps with indices. *)

val feature : Ast.feature read
(** Reads a feature, such as [top], [q.left.top] or [[a, b]]. *)

val member : only:bool -> Ast.member read
(** Reads a feature as a member of an active surface. [only] is copied into the result; the piece does not
    contain it. *)

val template : Ast.reference read
(** Reads a reference to a shape, such as [Cube], [m.Cube] or [Brick(1, 2)]. *)

val behaviour : Ast.reference read
(** Reads a reference to a behaviour, such as [K], [m.K(2)] or [K[i]]. *)

val head : Ast.head read
(** Reads the left side of the declaration of a behaviour: [K], [K[i, 0]] or [K(a, b)]. *)

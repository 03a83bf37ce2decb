(** What an element should hold, taken from it piece by piece: what is missing, what is left over and what is
    wrong in a text are reported, and something else of its kind stands in for it, so that a document is looked
    through to its end. *)

open Scc_base
open Scc_syntax

(** What has been found wrong. *)
type report

val report : unit -> report
val faults : report -> Diag.t list
val error : ?hint:string -> report -> Code.t -> Span.t -> ('a, unit, string, unit) format4 -> 'a
(** Raises {!Document.Stop} at the {!Parse.max_errors}th. *)

(** An element of which parts have been taken. *)
type t

val of_element : report -> Document.element -> t
val reports : t -> report
val element : t -> Document.element

val finish : t -> unit
(** Reports what has not been taken (SC0352). To be called once, at the end. *)

(** {1 Attributes} *)

(** How the text of an attribute is read, and what stands in for one that is missing or wrong. *)
type 'a text

val name : Ast.name text
val word : Ast.name text
val rounded : Ast.name text
val expression : Ast.expr text
val path : Ast.path text
val segment : Ast.segment text
val feature : Ast.feature text
val member : only:bool -> Ast.member text
val template : Ast.reference text
val behaviour : Ast.reference text
val head : Ast.head text
(** Perhaps with indices. *)

val plain_head : Ast.head text
(** A name alone. *)

val names : Ast.name list text
(** Separated by spaces. *)

val line : string Ast.loc text
(** Any text on one line. *)

val flag : bool text
(** [true], [false], [1] or [0]. *)

val choice : (string * 'a) list -> 'a text
(** One of these; the first stands in. *)

val has : t -> string -> bool
val optional : t -> string -> 'a text -> 'a option
val required : t -> string -> 'a text -> 'a
(** SC0353. *)

val content : t -> 'a text -> 'a
(** Of the text in the element. *)

(** {1 Elements} *)

val next : t -> string option
(** The tag of the first element that is left. *)

val take : t -> Document.element option
val many : t -> string list -> (t -> 'a) -> 'a list
(** As many as there are of these tags, one after another; each is finished. *)

val one : t -> string -> (t -> 'a) -> 'a option
val missing : t -> ('a, unit, string, unit) format4 -> 'a
(** What is expected where the next element stands, or the end tag (SC0353). *)

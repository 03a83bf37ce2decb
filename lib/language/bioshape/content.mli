(** The content of an element, taken piece by piece. Missing pieces, pieces left over and errors in texts are
    reported. A substitute of the same kind takes their place, so a document is read to its end. *)

open Scc_base
open Scc_syntax

(** The errors found so far. *)
type report

val report : unit -> report
(** A report without errors. *)

val faults : report -> Diag.t list
(** The errors in the order of the text, each once. *)

val error : ?hint:string -> report -> Code.t -> Span.t -> ('a, unit, string, unit) format4 -> 'a
(** Adds an error. Raises {!Document.Stop} at the {!Scc_syntax.Parse.max_errors}th. *)

(** An element of which parts have been taken. *)
type t

val of_element : report -> Document.element -> t
(** An element of which nothing has been taken. Its errors go to this report. *)

val reports : t -> report
(** The report of an element. *)

val element : t -> Document.element
(** The element itself, with all its parts. *)

val finish : t -> unit
(** Reports attributes, elements and text that have not been taken (SC0352). It must be called once, at the
    end. *)

(** {1 Attributes} *)

(** How the text of an attribute is read, and the substitute for one that is missing or wrong. *)
type 'a text

val name : Ast.name text
(** A name; the substitute is [_]. *)

val word : Ast.name text
(** A word to which a setting is set, as by {!Scc_syntax.Embedded.word}; the substitute is [_]. *)

val rounded : Ast.name text
(** A word after [round], as by {!Scc_syntax.Embedded.rounded}; the substitute is [_]. *)

val expression : Ast.expr text
(** An expression; the substitute is 0. *)

val path : Ast.path text
(** A path; the substitute is [_]. *)

val segment : Ast.segment text
(** A name, perhaps with indices; the substitute is [_]. *)

val feature : Ast.feature text
(** A feature; the substitute is [_]. *)

val member : only:bool -> Ast.member text
(** A feature as a member of an active surface, with this [only]; the substitute is [_]. *)

val template : Ast.reference text
(** A reference to a shape; the substitute is [_]. *)

val behaviour : Ast.reference text
(** A reference to a behaviour; the substitute is [_]. *)

val head : Ast.head text
(** The left side of a declaration, perhaps with indices or parameters; the substitute is [_]. *)

val plain_head : Ast.head text
(** The left side of a declaration that is a name alone; the substitute is [_]. *)

val names : Ast.name list text
(** One or more names, separated by white space; the substitute is none. *)

val line : string Ast.loc text
(** Any text on one line; the substitute is the empty text. *)

val flag : bool text
(** [true], [false], [1] or [0]; the substitute is false. *)

val choice : (string * 'a) list -> 'a text
(** [choice values] is one of the words in [values]; the substitute is the first. It needs at least one word. *)

val has : t -> string -> bool
(** [has t key] is true if the element has the attribute and it has not been taken. *)

val optional : t -> string -> 'a text -> 'a option
(** [optional t key kind] takes the attribute [key], if there is one. *)

val required : t -> string -> 'a text -> 'a
(** [required t key kind] takes the attribute [key]. A missing one is SC0353, and the result is the
    substitute. *)

val content : t -> 'a text -> 'a
(** [content t kind] takes the text in the element. *)

(** {1 Elements} *)

val next : t -> string option
(** The tag of the first element that has not been taken. *)

val take : t -> Document.element option
(** Takes the first element that is left. *)

val many : t -> string list -> (t -> 'a) -> 'a list
(** [many t tags read] takes elements as long as the next one has one of these tags, reads each of them and
    finishes it. *)

val one : t -> string -> (t -> 'a) -> 'a option
(** [one t tag read] takes the next element if it has this tag, reads it and finishes it. *)

val missing : t -> ('a, unit, string, unit) format4 -> 'a
(** [missing t fmt …] reports what is expected (SC0353), at the next element that is left, or at the start tag
    of [t] if none is left. *)

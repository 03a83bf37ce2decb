(** The declarations of a text, each with its place and a line that describes it. *)

open Scc_base
open Scc_syntax

(** The kind of a declaration. *)
type kind =
  | Model
  | Parameter
  | Value  (** of a [let], or after [where] *)
  | Index  (** the variable of a loop or of a quantifier over integers *)
  | Variable  (** of a quantifier over bodies *)
  | Argument  (** of a family *)
  | Shape
  | Compound
  | Part
  | Vertex
  | Face
  | Behaviour
  | Process
  | Fixed
  | Leaf
  | Check
  | Module
  | Imported  (** of another file, under a name of its own *)

(** A declaration. *)
type t = {
  kind : kind;
  name : Ast.name;
  what : string;
  shown : Span.t option;  (** the place of the declaration *)
  inner : t list;  (** declarations whose names may follow its own after a dot *)
  by_name : (string, t) Hashtbl.t Lazy.t;  (** [inner] by name *)
  solid : Ast.solid option;  (** the solid that has its features *)
  source : (Ast.import * string) option;
  (** the import that brings it, and its name there; [""] for a module itself *)
}

val kind : kind -> string
(** The kind as a word for programs, such as ["process"]. *)

val make : ?shown:Span.t -> ?inner:t list -> ?solid:Ast.solid -> kind -> Ast.name -> string -> t
(** [make kind name what] is a declaration with the description [what] and no import. [shown] (default: none) is
    its place. *)

val of_import : Ast.import -> Span.t -> t
(** The declaration of the module of an import, by its alias or its own name. *)

(** {1 A whole text} *)

type table = (string, t) Hashtbl.t
(** Declarations by name. A name may have several, as in a family. *)

(** All declarations of a text. *)
type all = private {
  items : (int, t) Hashtbl.t;  (** by the offsets of their names *)
  bodies : table;  (** processes, families and leaves *)
  behaviours : table;
  templates : table;
  values : table;  (** parameters and lets *)
  modules : table;
  features : table;  (** vertices, faces and parts of all templates *)
}

val of_model : Ast.model -> all
(** The declarations of a text, with those in loops. *)

val find : table -> string -> t list
(** The declarations of a name, in the order of the text. *)

val at : all -> Ast.name -> t list
(** The declarations whose name is at the place of this name: at most one. *)

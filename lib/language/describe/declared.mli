(** What a text declares, each with its place and a line that says what it is. *)

open Scc_base
open Scc_syntax

type kind =
  | Model
  | Parameter
  | Value  (** by [let], or after [where] *)
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

type t = {
  kind : kind;
  name : Ast.name;
  what : string;
  shown : Span.t option;  (** the text that says the rest *)
  inner : t list;  (** what its name may be followed by, after a dot *)
  by_name : (string, t) Hashtbl.t Lazy.t;  (** the same *)
  solid : Ast.solid option;  (** of which its features are *)
  source : (Ast.import * string) option;
  (** of what comes from elsewhere: from where, and its name there; [""], if it is a module *)
}

val kind : kind -> string
(** For programs: ["process"]. *)

val make : ?shown:Span.t -> ?inner:t list -> ?solid:Ast.solid -> kind -> Ast.name -> string -> t

val of_import : Ast.import -> Span.t -> t
(** The module that it is, by whatever name. *)

(** {1 A whole text} *)

type table = (string, t) Hashtbl.t
(** By name; several of one name as in a family. *)

type all = private {
  items : (int, t) Hashtbl.t;  (** by where their names begin *)
  bodies : table;  (** processes, families and leaves *)
  behaviours : table;
  templates : table;
  values : table;  (** parameters and lets *)
  modules : table;
  features : table;  (** vertices, faces and parts, of whatever *)
}

val of_model : Ast.model -> all

val find : table -> string -> t list
(** In the order of the text. *)

val at : all -> Ast.name -> t list
(** What is declared at this place: one, if anything is. *)

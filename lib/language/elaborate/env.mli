(** What names stand for at a place of the text. Names of values (parameters, loop variables, [let]s, the formal
    parameters of families, the variables of quantifiers) have lexical scopes: a name may be used after its
    declaration, and an inner one hides an outer one. Names of shapes and behaviours belong to the text that
    declares them, the model or a module that it imports: each has a global name, in which that of a module is
    put before its own. *)

open Scc_base
open Scc_exact
open Scc_syntax

type value =
  | Number of Rat.t
  | Truth of bool
  | Vector of Vec.t
  | Affine of Form.t  (** what depends on parameters of which ranges are known: no constant *)
  | Word of string * t
  (** the argument of a family that is no value: the name of a channel, a feature or a behaviour, and where it was
      written *)
  | Macro of Ast.expr * t  (** a [let] that is no constant, with the scope of its declaration *)
  | Leaf of int  (** a process variable of a quantifier: an index into {!Scc_calculus.Model.leaves} *)
  | Unknown
  (** the parameter of a family that nothing uses, which is read without arguments: nothing is said of what depends
      on it *)

and binding = { value : value; span : Span.t; mutable used : bool }

and t

(** A text: the model, or a module. *)
and scope = {
  prefix : string;  (** of the global names of what it declares; empty for the model *)
  file : string;  (** its path, relative to the folder of the model *)
  modules : (string, scope) Hashtbl.t;  (** by the qualifiers of its imports *)
  chosen : (string, string) Hashtbl.t;  (** names chosen from imports, with the global ones *)
  top : (string, binding) Hashtbl.t;  (** its values outside loops *)
  declared : (string, unit) Hashtbl.t;  (** its shapes and behaviours, families by their bare name *)
}

val scope : prefix:string -> file:string -> scope

val root : scope -> t
(** No values yet. *)

val add : string -> binding -> t -> t

val find : t -> string -> value option
(** Marks the binding as used. *)

val mem : t -> string -> bool

val value : t -> Ast.segment list -> (value * Ast.segment list) option
(** [n], or [m.n] of an imported module, and the segments that follow the name. *)

val is_module : t -> string -> bool
(** The name qualifies what an import brings, and stands for no value. *)

val global : t -> string option -> string -> string option
(** The global name of a shape or behaviour, by its qualifier and name; [None] when the qualifier is unknown.
    Whether
    there is one of that name is not looked at. *)

val scope_of : t -> scope

val is_own : t -> bool
(** The text is the model, and no module. *)

val own : t -> string -> string
(** The global name of what is declared here. *)

val declares : t -> string -> bool
(** A shape or behaviour of that name is declared or chosen in this text. *)

val names : t -> string list
val modules : t -> string list

val beside : t -> string -> string
(** The path of a file that the text names, relative to the folder of the model. *)

(** The meanings of names at a place of the text. Values are parameters, loop variables, [let]s, formal
    parameters of families and variables of quantifiers. Their names have lexical scopes: a name may be used
    after its declaration, and an inner one hides an outer one.

    Names of shapes and behaviours belong to the text that declares them, which is the model or an imported
    module. Each has a global name: its own name after the prefix of its module. *)

open Scc_base
open Scc_exact
open Scc_syntax

type value =
  | Number of Rat.t
  | Truth of bool
  | Vector of Vec.t
  | Affine of Form.t  (** depends on parameters with known ranges, and is no constant *)
  | Open of Scc_calculus.Open_number.t  (** a function of the parameter of [--parametric] *)
  | Word of string * t
  (** the argument of a family that is no value: the name of a channel, a feature or a behaviour, and the scope in
      which it was written *)
  | Macro of Ast.expr * t  (** a [let] that is no constant, with the scope of its declaration *)
  | Leaf of int  (** a process variable of a quantifier: an index into {!Scc_calculus.Model.leaves} *)
  | Unknown
  (** the parameter of a family that nothing uses, which is read without arguments; what depends on it is unknown
      as well *)

and binding = { value : value; span : Span.t; mutable used : bool }

(** The values in scope at a place, and the text around it. *)
and t

(** A text: the model, or a module. *)
and scope = {
  prefix : string;  (** of the global names of what it declares; empty for the model *)
  file : string;  (** its path, relative to the folder of the model *)
  missing : bool;  (** it cannot be read *)
  modules : (string, scope) Hashtbl.t;  (** by the qualifiers of its imports *)
  chosen : (string, string) Hashtbl.t;  (** names chosen from imports, with the global ones *)
  top : (string, binding) Hashtbl.t;  (** its values outside loops *)
  declared : (string, unit) Hashtbl.t;  (** its shapes and behaviours, families by their bare name *)
}

val scope : ?missing:bool -> prefix:string -> file:string -> unit -> scope
(** [scope ~prefix ~file ()] is a text without declarations or imports. With [missing] it stands for a text that
    cannot be read, which has been reported. *)

val root : scope -> t
(** [root scope] is the environment at the start of a text: no values. *)

val add : string -> binding -> t -> t
(** [add name binding env] has the new binding, which hides any other of this name. *)

val find : t -> string -> value option
(** [find env name] is the value of a name in scope. It marks the binding as used. *)

val mem : t -> string -> bool
(** [mem env name] is true if a value of this name is in scope. It marks nothing as used. *)

val value : t -> Ast.segment list -> (value * Ast.segment list) option
(** The value of the name at the start of a path, [n] or [m.n] with an imported module [m], and the segments
    after it. The binding is marked as used. *)

val is_module : t -> string -> bool
(** [is_module env name] is true if an import has this qualifier and no value in scope has this name. *)

val global : t -> string option -> string -> string option
(** [global env qualifier name] is the global name of a shape or behaviour. It is [None] if the qualifier is
    unknown; there need not be a declaration of that name. *)

val written : t -> string -> string option
(** [written env name] is how the text writes the shape or behaviour with this global name: [n], or [m.n] with the
    name that the text gives to an import. It is [None] if the text has no name for it. *)

val said : t -> string -> string
(** [said env label] is the label of a shape or behaviour, perhaps with indices or arguments, as the text would
    write it ({!written}), for messages about this text. What the text has no name for keeps its global name. *)

val is_missing : t -> string -> bool
(** [is_missing env qualifier] is true if the import with this qualifier cannot be read. *)

val scope_of : t -> scope
(** The text to which the environment belongs. *)

val is_own : t -> bool
(** [is_own env] is true if the text is the model and not a module. *)

val own : t -> string -> string
(** [own env name] is the global name of what this text declares as [name]. *)

val declares : t -> string -> bool
(** [declares env name] is true if this text declares a shape or behaviour of this name or chooses one from an
    import. *)

val names : t -> string list
(** The names of the values in scope, sorted. *)

val modules : t -> string list
(** The qualifiers of the imports of this text, sorted. *)

val beside : t -> string -> string
(** [beside env path] is the path, relative to the folder of the model, of a file that the text names. An
    absolute path is unchanged. *)

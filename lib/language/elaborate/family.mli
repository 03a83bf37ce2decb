(** Families: declarations with indices or parameters. [behaviour K[i, j]] declares K for all integers, and
    [behaviour K[1, 0]] for these two, which goes before the general one. [K(a, b)] takes numbers, truth values,
    vectors and names.

    Each instance is a declaration of its own. Its label is its reference as written: [K[2,3]],
    [K(1/2,dock)]. *)

open Scc_syntax

(** The key and the parameters of a declaration. *)
type head = {
  key : string;  (** a name by itself, [K[1,2]], or [K[_,_]] and [K(_,_)] for those with formal parameters *)
  formals : Ast.name list;
}

val head : Report.t -> Env.t -> Ast.head -> head option
(** Reads the left side of a declaration. Indices are formal parameters if each of them is a name without a
    value. Otherwise they are constant integers. *)

(** A use of a declaration, with its arguments evaluated. *)
type reference = {
  label : string;  (** the label of the instance *)
  keys : string list;  (** the keys under which it may be declared, the most special first *)
  arguments : Env.value list;
}

val reference : Report.t -> Env.t -> Ast.reference -> reference option
(** Reads a use of a declaration. An argument that is a name without a value is the name of a channel, a feature
    or a behaviour. An unknown qualifier is SC0201. *)

val unknown : Ast.name list -> Env.value list
(** Arguments, all [Unknown], with which a family is read for its faults alone. *)

val is_open : reference -> bool
(** [is_open r] is true if an argument is unknown. Such a reference has no instance, though its family may
    exist. *)

val find : (string, 'a) Hashtbl.t -> reference -> 'a option
(** The declaration of a reference: the first of its keys that the table has. *)

val has : (string, 'a) Hashtbl.t -> reference -> bool
(** [has table r] is true if {!find} has a result. For an open reference with indices, a key with as many
    indices is enough. *)

val word : Env.t -> string -> string
(** [word env name] is the name for which a formal parameter stands, or [name] itself. *)

val bind : Env.t -> Ast.name list -> Env.value list -> Env.t
(** [bind env formals arguments] binds each formal parameter to its argument. The lists have equal lengths
    unless there are no formal parameters. *)

val define : Report.t -> Env.t -> Ast.definitions -> Env.t
(** Adds the definitions after [where] to the scope, in order. *)

val bare : string -> string
(** The name in a label or key, without indices and arguments. *)

val keys : (string, 'a) Hashtbl.t -> string list
(** The keys of a table, sorted. *)

val report_unknown :
  Report.t -> Env.t -> string -> string list -> ?predefined:string list -> Ast.reference -> reference -> unit
(** [report_unknown report env what keys r reference] reports that no declaration fits (SC0201). [what] is its
    kind, such as ["behaviour"]. The message lists the keys of the same name, or else suggests one: that of an
    import of which the qualifier was left out, or a similar one. What an import that cannot be read would declare
    is not reported. *)

(** Families: declarations with indices or parameters. [behaviour K[i, j]] is one for all integers, [behaviour
    K[1, 0]]
    one of them (and counts before the one for all), [K(a, b)] takes numbers, truth values, vectors and names. Each
    instance is a declaration of its own, labelled as it would be written: [K[2,3]], [K(1/2,dock)]. *)

open Scc_syntax

(** What a declaration enters. *)
type head = {
  key : string;  (** a name by itself, [K[1,2]], or [K[_,_]] and [K(_,_)] for those with formal parameters *)
  formals : Ast.name list;
}

val head : Report.t -> Env.t -> Ast.head -> head option
(** An index that is a name without a value here is a formal parameter if all of them are. *)

type reference = {
  label : string;  (** of the instance *)
  keys : string list;  (** under which it may have been declared, the most special first *)
  arguments : Env.value list;
}

val reference : Report.t -> Env.t -> Ast.reference -> reference option
(** An argument that is a name without a value is the name of a channel, a feature or a behaviour. *)

val unknown : Ast.name list -> Env.value list
(** Arguments to read a family without any. *)

val is_open : reference -> bool
(** An argument depends on what is unknown: there is such a family, or not, but no instance. *)

val find : (string, 'a) Hashtbl.t -> reference -> 'a option

val has : (string, 'a) Hashtbl.t -> reference -> bool
(** There is one; for what is open, one with as many indices or parameters. *)

val word : Env.t -> string -> string
(** The name that a formal parameter stands for; any other name itself. *)

val bind : Env.t -> Ast.name list -> Env.value list -> Env.t
(** Formal parameters, if there are any, to as many arguments. *)

val define : Report.t -> Env.t -> Ast.definitions -> Env.t
(** The definitions after [where], in order. *)

val bare : string -> string
(** A label or key without indices and arguments. *)

val keys : (string, 'a) Hashtbl.t -> string list

val report_unknown : Report.t -> string -> string list -> Ast.reference -> reference -> unit
(** Reports that there is no such thing ("behaviour"), and which of these keys are near it. *)

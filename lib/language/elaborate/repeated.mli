(** The families that the loops of a model declare. A loop over an empty range declares families without
    members. *)

open Scc_syntax

(** The names of families as written, in order. A name stands there once for each declaration. *)
type t = {
  bodies : Ast.name list;  (** of processes, fixed bodies and their leaves whose names have indices *)
  checks : Ast.name list;
}

val of_model : Ast.model -> t
(** The families that are declared in loops, whatever their ranges are. *)

val has_body : t -> string -> bool
(** [has_body t name] is true if a family of bodies has this name. *)

val has_check : t -> string -> bool
(** [has_check t name] is true if a family of checks has this name. *)

(** Imports: each file is read once, whatever imports it, and is a scope of its own. *)

open Scc_syntax

(** The modules read so far, and the imports of the model. *)
type t

val create : unit -> t
(** No modules yet. *)

val start : t -> Env.scope -> Ast.model -> unit
(** Enters the model itself, which no module may import. *)

val called : t -> Env.scope -> string -> string list
(** [called t scope name] is the list of names that the model has for a value of a text by its imports, wherever
    they stand. It is [w.n] after [import "x.sc" as w], and [m] after [import "x.sc" (n as m)]. *)

val may_hold : Ast.item -> bool
(** [may_hold item] is true if a module may contain this declaration: a parameter, [let], shape, compound,
    behaviour, import, or a loop of these. *)

val import :
  t ->
  Report.t ->
  read_file:(string -> (string, string) result) ->
  read:(Env.scope -> Ast.model -> unit) ->
  Env.t ->
  Ast.import ->
  Env.t
(** Reads an import. Its qualifier and chosen names are entered in the scope, and the result also has the chosen
    values. The path is relative to the importing file.

    Files that cannot be read are SC0101, imports in a circle SC0216, unknown names and libraries SC0201, names
    in use SC0202. Errors of the parser are reported as well. *)

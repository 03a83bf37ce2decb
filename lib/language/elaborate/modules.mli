(** Imports: each file is read once, whoever imports it, and is a scope of its own. *)

open Scc_syntax

type t

val create : unit -> t

val start : t -> Env.scope -> Ast.model -> unit
(** The model itself, which no module may import. *)

val called : t -> Env.scope -> string -> string list
(** What the model calls a value of a text, by its imports of it, wherever they stand: [w.n] after
    [import "x.sc" as w], [m] after [import "x.sc" (n as m)]. *)

val may_hold : Ast.item -> bool
(** A module may hold this declaration: a parameter, [let], shape, compound, behaviour, import, or a loop of
    these. *)

val import :
  t ->
  Report.t ->
  read_file:(string -> (string, string) result) ->
  read:(Env.scope -> Ast.model -> unit) ->
  Env.t ->
  Ast.import ->
  Env.t
(** What comes after the import sees: qualifiers and chosen names are entered in the scope, chosen values are
    bound. The
    path is relative to the file that imports. Reports files that cannot be read (SC0101) or parsed, imports in
    a circle
    (SC0216), unknown names and libraries (SC0201), and names that are taken (SC0202). *)

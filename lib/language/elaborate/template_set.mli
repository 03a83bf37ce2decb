(** The faces of one template of a model, also if they enclose no solid. *)

open Scc_base
open Scc_exact
open Scc_geometry
open Scc_syntax

val find :
  read_file:(string -> (string, string) result) ->
  overrides:(string * Rat.t) list ->
  asked_at:Span.t ->
  Ast.model ->
  string ->
  (Polyhedron.ifs * Diag.t list, Diag.t list) result
(** [find ~read_file ~overrides ~asked_at model name] is the faces of the template [name], and warnings. Only
    the parameters and templates of the model are read, and the faults of the polyhedron are not checked. An
    unknown name is SC0201 at [asked_at]. A value for an unknown parameter is SC0209, and a compound SC0210. *)

val names : Ast.model -> string list
(** The heads of the shapes that the model declares outside loops, in order of declaration. *)

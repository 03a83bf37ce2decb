(** The indexed face set of one template of a model, whether or not it is accepted. *)

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
  (Polyhedron.ifs, Diag.t list) result
(** Looks at the parameters and templates of the model only. An unknown name, at [asked_at], is
    SC0201, and a value for a parameter that there is not SC0209. The faults of the
    polyhedron are not looked for. *)

val names : Ast.model -> string list
(** Of the templates, in order of declaration. *)

(** Solids from polyhedron files. *)

open Scc_geometry
open Scc_syntax

val read :
  Report.t ->
  Env.t ->
  read_file:(string -> (string, string) result) ->
  string Ast.loc ->
  Ast.expr option ->
  Polyhedron.ifs option
(** The file's set of faces, snapped within the distance if one is given; not checked else. What is wrong is
    reported: SC0101, the codes of {!Scc_mesh.Mesh.read}, SC0322. *)

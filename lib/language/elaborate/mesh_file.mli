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
(** Reads the faces of a file, snapped within the distance if one is given. Nothing else is checked. Faults are
    reported: SC0101, the codes of {!Scc_mesh.Mesh.read}, SC0322. *)

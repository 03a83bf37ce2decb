(** Solids from polyhedron files. *)

open Scc_geometry
open Scc_syntax

val read :
  Report.t ->
  Env.t ->
  read_file:(string -> (string, string) result) ->
  string Ast.loc ->
  Ast.mending ->
  Polyhedron.ifs option
(** Reads the faces of a file, mended as is asked for: on a grid, welded, oriented, merged, snapped. Nothing
    else is checked. Faults are reported: SC0101, the codes of {!Scc_mesh.Mesh.read}, SC0303, SC0322. *)

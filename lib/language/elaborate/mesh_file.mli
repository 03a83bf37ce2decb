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
(** Reads the faces of a file, mended as is asked for: on a grid, welded, oriented, merged, snapped, and the
    surface of their union, which has to be convex. Nothing else is checked. Faults are reported: SC0101, the codes
    of {!Scc_mesh.Mesh.read}, SC0303, SC0307, SC0322, and those of {!Scc_concave.Decomposed.message}. *)

val flat : Report.t -> string Ast.loc -> Polyhedron.ifs -> Polyhedron.ifs
(** [flat report path set] has triangles for the faces that are not flat. A warning at the path of the file says
    how far their corners are off a plane (SC0323). *)

val union_hint : Polyhedron.ifs -> Ast.mending -> Scc_concave.Decomposed.fault -> string option
(** The word after the file that mends faces of which there is no union, if there is one that is not there yet. *)

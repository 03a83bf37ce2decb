(** XYZ files of points, as scanners write them: a line [x y z] for each point, and what follows on it (normals,
    colours, …) is not looked at. The first line may be the number of points, as in CGAL. The files of that name in
    which chemists write atoms are told by their letters, and refused. *)

open Scc_base
open Scc_geometry

val read : path:string -> string -> (Polyhedron.ifs, Diag.t) result
(** A cloud: vertices without faces. *)

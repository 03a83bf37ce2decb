(** XYZ files of points, as scanners write them: a line [x y z] for each point. The rest of the line (normals,
    colours, …) is ignored. The first line may be the number of points, as in CGAL. Files of atoms in chemistry
    have the same ending; they contain letters, and are refused. Semicolons may stand between numbers, and commas
    if each line has three numbers with two commas: other commas may be those of decimals, and are refused. *)

open Scc_base
open Scc_geometry

val read : path:string -> string -> (Polyhedron.ifs, Diag.t) result
(** A cloud: vertices without faces. Errors (SC0320) are located in the file. *)

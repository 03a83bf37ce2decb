(** What is done to a mesh on request so that it becomes the boundary of a solid. Each function tells what it did,
    in a sentence for a person; nothing here is done silently by {!Mesh.read}. Indices are in range (a bug
    otherwise). All take near linear time. *)

open Scc_exact
open Scc_geometry

val on_grid : Rat.t -> Polyhedron.ifs -> Polyhedron.ifs * string
(** Every coordinate becomes the nearest multiple of a distance > 0: points move by at most half of it along each
    axis. Told: how many moved, and the farthest. *)

val weld : Polyhedron.ifs -> Polyhedron.ifs * string
(** Vertices at the very same point become one, which has the name of the first; corners that repeat their
    neighbour go, faces of fewer than three corners go, and so do vertices that no face uses (not those of a
    cloud, which has no faces). *)

val orient : Polyhedron.ifs -> (Polyhedron.ifs * string, string) result
(** Faces are turned over so that any two neighbours along an edge of just two faces agree; the first face of a
    piece says how. A closed piece of negative volume is turned over as a whole, unless its box is strictly inside
    of that of another piece: then it may be a cavity and stays, which is told. [Error]: a surface like a Möbius
    strip, with a face at which it was found, or more than 1000 pieces. *)

val merge : Polyhedron.ifs -> Polyhedron.ifs * string
(** {!Merge_coplanar.merge}; a cloud of points, without faces, stays as it is. *)

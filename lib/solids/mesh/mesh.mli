(** Readers of polyhedron files. Coordinates are read exactly: decimals as written, binary floating-point
    numbers as the dyadic rationals that they are. *)

open Scc_base
open Scc_geometry

val formats : (string * string) list
(** The endings of names that {!read} knows, each with the name of the format. *)

val read : files:Beside.reader -> path:string -> string -> (Polyhedron.ifs * Diag.t list, Diag.t) result
(** [read ~files ~path text] is what a file describes, with warnings: of what is read nearly (SC0323), and of what
    is left out (SC0324). The ending of the name ([.off], [.obj], …) determines the format, or the
    beginning of the text if the ending is unknown. Vertices are named [v0, v1, …] and faces [f0, f1, …] in the
    order of the file. [files] reads the files that the file names, by {!Beside.find}.
    Faces are those of the file. An STL file has only triangles: there equal points become
    one vertex and {!Merge_coplanar} makes maximal faces. Errors (SC0320, SC0321) are located in the file. Time
    and memory are near linear in its size, whatever its header says. A set of fractions whose common
    denominator is too long is SC0106. *)

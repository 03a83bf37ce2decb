(** Solids of one mesh that touch each other, or that walls divide. *)

open Scc_geometry

val advice : union:bool -> Polyhedron.ifs -> string option
(** A line that says what takes the solids of a mesh whose faces are at fault, if they share faces or edges. Or it
    says which walls are to be removed; [None] for all others. Corners are the same if their positions are.
    Except for shared faces, what the line says has been tried. With [union], the option [--union] is given, and
    is not named. *)

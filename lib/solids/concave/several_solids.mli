(** What can be done about a mesh that is no solid, beside mending it: solids that touch each other, walls within
    one, and sheets. *)

open Scc_geometry

val advice : ?union:(orient:bool -> string) -> Polyhedron.ifs -> string option
(** A line that says what takes the solids of a mesh whose faces are at fault, if they share faces or edges. Or it
    says which walls are to be removed, or that the mesh is a sheet; [None] for all others. Corners are the same if
    their positions are. Except for shared faces, what the line says has been tried. [union] is how their union is
    asked for, with pieces that are inside out turned over or not. It is left out where the union has been asked
    for. *)

(** Faces that are not flat, in triangles. *)

open Scc_geometry

val triangulated : Polyhedron.ifs -> (Polyhedron.ifs * string) option
(** [triangulated set] has triangles for each face with a corner off its plane. Their corners are those of the
    face. The first has its name [f], the others [f_2], [f_3], … or the next names that nothing has. The text
    counts the faces and says how far corners are off their planes, rounded. [None] if there are no such faces.
    Faces stay as they are if they have faults of other kinds, such as corners out of range. *)

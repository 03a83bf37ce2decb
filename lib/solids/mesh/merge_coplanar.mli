(** From many small faces to maximal ones. *)

open Scc_geometry

val merge : Polyhedron.ifs -> Polyhedron.ifs
(** Faces of one plane that look to the same side and are neighbours along an edge become one face, when
    their outline is one simple closed line (otherwise they stay as they are). Corners at which every
    outline that has them goes straight on disappear, and so do the vertices that no face uses any more.
    A face keeps the name of its first part, and vertices keep theirs. The surface, as a set of points, is
    the same. Indices are in range (a bug otherwise). Near linear. *)

val unite : Polyhedron.ifs -> int array -> Polyhedron.ifs
(** The same for groups of faces that are given, as the least face of the group of each, be they in one plane or
    not. Vertices on fewer than three of the new faces disappear. *)

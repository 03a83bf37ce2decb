(** The union of small faces into maximal ones. *)

open Scc_geometry

val merge : Polyhedron.ifs -> Polyhedron.ifs
(** Faces of one plane and one orientation that share an edge become one face, if the outline of their union is
    one simple closed line. Otherwise they stay as they are. Corners at which every outline that has them is
    straight are dropped, and so are vertices that no face uses any more. A face has the name of its first
    part, and vertices keep theirs. The surface, as a set of points, is unchanged. Indices are in range (a bug
    otherwise). Near linear time. *)

val unite : Polyhedron.ifs -> int array -> Polyhedron.ifs
(** [unite set group] unites given groups of faces, whether they are in one plane or not, under the conditions
    of {!merge} on outlines. The array has the least face of the group of each face. Vertices on fewer than
    three of the new faces are dropped. *)

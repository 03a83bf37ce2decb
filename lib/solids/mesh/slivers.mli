(** Faces without an area: all their corners are on one line. *)

open Scc_geometry

val is_sliver : Polyhedron.ifs -> int -> bool
(** [is_sliver set f] is true if face [f] has at least three corners, all on one line. *)

val dissolved : Polyhedron.ifs -> Polyhedron.ifs
(** [dissolved set] is the set without the faces without an area whose neighbours can take in their corners.
    Each edge of such a face is an edge of one other face, the other way round; this gets the corners between
    its ends. So edges stay closed that were closed. A face stays if it has an edge that is not in two faces,
    one for each direction. Indices are in range. Time is near linear, for at most a hundred such faces on top
    of each other. *)

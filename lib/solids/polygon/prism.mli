(** Prisms: solids between two parallel planes that a polygon sweeps along one vector. *)

open Scc_exact

val pieces : vertices:Vec.t array -> faces:int array array -> int array list option
(** [pieces ~vertices ~faces] are convex prisms whose union is a prism over a polygon, with holes or without,
    right or oblique. The faces are those of a closed polyhedron: flat, counter-clockwise as seen from outside,
    without self-intersections. Faces of a plane may be cut into triangles. Each piece is the hull of these
    vertices, which need not all be corners of it; there are as many pieces as {!Partition.convex} has. [None]
    if the polyhedron is no prism, if a corner of one cap has no counterpart on the other, or if it is not in
    one piece. *)

(** Prisms: solids between two parallel planes that a polygon sweeps along one vector. *)

open Scc_exact

val pieces : vertices:Vec.t array -> faces:int array array -> int array list option
(** Of a closed polyhedron (faces with their corners counter-clockwise as seen from outside, flat, without
    self-intersections; faces of a plane may be cut into triangles): if it is a prism over a polygon, with holes or
    without, right or oblique, the vertices of convex prisms that it consists of, as many as {!Partition.convex}
    has pieces. Each is the hull of these vertices, which need not all be corners of it. [None] if it is no
    prism, if not every corner of one cap has its like on the other, or if it is not in one piece. *)

(** The distance of a simplified surface from the original one. *)

val between : Relief.t -> Triangulation.t -> int
(** The greatest difference of the heights of the two anywhere in the plane, in quanta, rounded up. Beyond its
    outline each height is 0. Both are linear on the pieces into which the two sets of triangles cut each
    other. So the greatest difference is at a corner of a piece: a corner of the surface, a vertex of the
    triangulation, or a crossing of two edges. All of these are compared, exactly. *)

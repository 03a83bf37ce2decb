(** How far a simplified surface is from the one that it stands for. *)

val between : Relief.t -> Triangulation.t -> int
(** Nowhere in the plane do the heights of the two differ by more, in quanta, rounded up; beyond its outline
    each is 0. Both are linear on the pieces that the two sets of triangles cut each other into, so that the
    greatest difference is at a corner of such a piece: a corner of the surface, a vertex of the triangulation,
    or where an edge of the one crosses an edge of the other. All of these are looked at, exactly. *)

(** Triangles of a polygon with holes. *)

val triangles : Outline.loop list -> (int * int) array * (int * int * int) list
(** The corners of all loops, and triangles of them, counter-clockwise on the screen, that cover the polygon and
    overlap nowhere. The first loop is the outer one, counter-clockwise on the screen, and the others are holes in
    it, clockwise. Loops are simple and do not touch each other (a bug otherwise). By cutting off ears, after each
    hole was joined to what is around it. *)

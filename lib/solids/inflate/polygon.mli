(** Triangles of a polygon with holes. *)

val triangles : Outline.loop list -> (int * int) array * (int * int * int) list
(** The corners of all loops, and triangles of them, counter-clockwise on the screen, that cover the polygon
    without overlap. The first loop is the outer one, counter-clockwise on the screen. The others are holes in
    it, clockwise. Loops are simple and do not touch each other (a bug otherwise). The method cuts off ears,
    after each hole was joined to the loop around it. *)

(** The union of solids that overlap or touch each other, or of one that touches itself. *)

open Scc_geometry

val surface : tick:(unit -> unit) -> Polyhedron.ifs -> Polyhedron.ifs option
(** [surface ~tick set] is the surface of the points that the faces surround at least once. A face counts once on
    each way out of the solid, and takes one away on each way in. So hollows stay, and what is in two solids is in
    their union. Its faces are sound ({!Sound}), but for edges that more than two of them may have.

    A face that others neither cut nor cover is there as it was, with corners of others on its edges. What is left
    of another face is convex polygons: the first has its name, further ones of a face [f] are [f_2], [f_3], ….
    Where several faces cover each other and look the same way, what is there belongs to the first one. A vertex
    has the name of a vertex there, or else [w1], [w2], …. There are no faces if those of the set surround nothing.

    [None] if there are no faces, or if they are not closed: each edge needs as many faces that run along it one
    way as the other way, by places. Also [None] if faces are not flat or not simple. [tick] is called again and
    again, and may raise. *)

val takes : Polyhedron.ifs -> bool
(** True if {!surface} has a surface of the set for certain: its faces are closed, flat and simple, and their
    volume is positive. *)

(** The union of solids that overlap or touch each other, or of one that touches itself. *)

open Scc_geometry

val parts : tick:(unit -> unit) -> Polyhedron.ifs -> (Polyhedron.t list * Polyhedron.ifs) option
(** [parts ~tick set] are convex parts, without common inner points, of the points that the faces surround at
    least once. A face counts once on each way out of the solid, and takes one away on each way in. So hollows
    stay, and what is in two solids is in their union. The set is the surface of the parts: convex polygons,
    each edge of which is an edge of others. A polygon has the name of the first face of the set in which it lies
    and which looks the same way; further ones of a face [f] are [f_2], [f_3], …. A vertex has the name of a
    vertex there, or else [w1], [w2], …. There are no parts if the faces surround
    nothing. [None] if there are no faces, or if they are not closed: each edge needs as many
    faces that run along it one way as the other way, by places. Also [None] if faces are not flat or not simple.
    [tick] is called again and again, and may raise. *)

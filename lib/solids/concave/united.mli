(** The union of solids that overlap or touch each other, or of one that touches itself. *)

open Scc_geometry

type fault =
  | Not_closed
  (** There are no faces, or some edge does not have as many faces that run along it one way as the other way, by
      places. Or faces are not flat or not simple. *)
  | Inside_out of { face : int; whole : bool }
  (** Some place is surrounded less than no time by a piece of surface with this face, the first one of the piece,
      and no other piece surrounds it. So the piece is inside out, and is no hollow. Without [whole], its volume is
      positive: it goes through itself, and a part of it is inside out. *)

val surface : tick:(unit -> unit) -> Polyhedron.ifs -> (Polyhedron.ifs, fault) result
(** [surface ~tick set] is the surface of the points that the faces surround at least once. A face counts once on
    each way out of the solid, and takes one away on each way in. So hollows stay, and what is in two solids is in
    their union. Its faces are sound ({!Sound}), but for edges that more than two of them may have.

    A face that others neither cut nor cover is there as it was, with corners of others on its edges. What is left
    of another face is convex polygons: the first has its name, further ones of a face [f] are [f_2], [f_3], ….
    Where several faces cover each other and look the same way, what is there belongs to the first one. A vertex
    has the name of a vertex there, or else [w1], [w2], …. There are no faces if those of the set surround nothing.

    A hollow may be inside out beyond a place that is in another hollow as well: what counts is that some piece of
    surface surrounds the place. [tick] is called again and again, and may raise. *)

val sheets : Polyhedron.ifs -> Sheets.t array option
(** The faces as convex polygons, if {!surface} does not find them [Not_closed]. *)

val takes : Polyhedron.ifs -> bool
(** True if {!surface} has a surface of the set for certain, but for pieces that are inside out: its faces are
    closed, flat and simple, and their volume is positive. *)

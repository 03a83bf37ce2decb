(** Solids cut into convex parts by planes of their faces, as in a binary space partition, and put together again where
    they stay convex. *)

open Scc_geometry

val parts : limit:int -> Drawn.t -> Polyhedron.t list option
(** Of a sound solid ({!Sound.faults}). Each cut is by the plane of a face that bounds the solid inside of what is cut,
    so that it goes through a reflex edge, or apart from all edges; a solid that is convex stays whole. Parts are merged as
    long as two of them have a whole face in common and a convex union. With f faces there are less than 2^f, in practice
    about as many as reflex edges. [None] where more cells than the limit would be needed on the way. *)

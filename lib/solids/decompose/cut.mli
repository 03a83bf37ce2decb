(** Space, cut by planes through the reflex edges of a solid until in each cell the solid is convex. *)

val parts : tick:(unit -> unit) -> Cell.t -> (Plane.t * Homogeneous.t array) list -> Cell.t list list
(** The convex parts of a closed solid without self-intersections, none of which share inner points; their
    union is the solid. The list has the parts of one way, or of two: solids with few reflex edges are cut by
    both preferences of {!Notch.plane}, since neither of them makes the fewest parts of all solids. The surface
    is given as convex polygons, each with its plane, in front of which is the outside. All of them are inside
    the cell, a box.

    A cell holds those pieces of the surface that are not in its walls, and what is left there of the reflex
    edges. It is cut by a plane through a reflex edge ({!Notch}). A plane strictly between the two faces at the
    edge leaves pieces in both halves. Behind the plane of a face is the inside, next to it. So that half is
    wholly inside if it has no pieces; in front are pieces of the other face.

    Where no reflex edge is left, or none is known, the cell is cut by the plane of a piece P in front of which
    there are others. Then, too, the space behind P is inside the solid, and the space in front is outside. So
    a half without pieces is wholly inside or outside. Where no piece is in front of the plane of another, the
    solid in the cell is what is behind all planes. On the plane of P that is a convex polygon, which the
    pieces of this plane cover. The reason: at its edge, a piece continues in a piece of another plane, and has
    nothing in front of that. Each cut takes its plane out of both halves. There are at most as many planes as
    triples of corners, so the cutting ends. [tick] is called at each cell.

    The number of parts has a bound if each reflex edge is cut by one plane and each cut affects one connected
    part. Then each of r edges is cut by the planes of the others into r pieces at most, and each piece makes
    one part more. So r (r + 1) / 2 + 1 parts would suffice. Some solids need a number of this order (Chazelle,
    Convex partitions of polyhedra: a lower bound and worst-case optimal algorithm, SIAM J. Comput. 13, 1984).
    Here each piece of an edge gets the plane that seems best, and a cut goes through the whole cell. As a rule
    that makes fewer parts, often fewer than reflex edges, as one plane goes through several edges. The only
    bound that is known here is the number of cells that all these planes make. *)

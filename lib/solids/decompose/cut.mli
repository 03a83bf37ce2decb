(** Space, cut by planes through the reflex edges of a solid until in each cell the solid is convex. *)

val parts : tick:(unit -> unit) -> Cell.t -> (Plane.t * Place.t array) list -> Cell.t list
(** The surface of a closed solid without self-intersections as convex polygons, each with its plane, in front
    of which is the outside; all of it inside the box. The cells are convex, have no inner point in common,
    and are together the solid.

    A cell holds those pieces of the surface that are not in its walls, and what is left there of the reflex
    edges. It is cut by a plane through a reflex edge ({!Notch}). One that is strictly between the two faces
    there leaves pieces in both halves. Behind that of a face is the inside, next to it, so that this half is
    wholly inside if it has no pieces; in front are pieces of the other face.

    Where no reflex edge is left, or none is known, it is cut by the plane of a piece P in front of which there
    are others: then, too, what is behind is inside the solid next to P, and what is in front is outside, so
    that a half without pieces is wholly inside or outside. Where no piece is in front of the plane of another,
    the solid in the cell is what is behind them all: on the plane of P that is a convex polygon, of which the
    pieces of this plane are all; for the surface goes on at the edge of a piece in the plane of another one,
    and has nothing in front of that. Each cut takes its plane out of both halves, and there are no more planes
    than triples of corners, so there is an end. [tick] is called at each cell.

    How many parts there are: where all that is left of a reflex edge is cut by one plane, and each cut is of
    one part that hangs together, each of r edges is cut by the planes of the others into r pieces at most; each
    of these makes one part more, so that r (r + 1) / 2 + 1 would do, and some solids need a number of this
    order (Chazelle, Convex partitions of polyhedra: a lower bound and worst-case optimal algorithm, SIAM J.
    Comput. 13, 1984). Here each piece of an edge gets the plane that seems best, and a cut goes through the
    whole cell. That comes to fewer parts as a rule, often fewer than reflex edges, as one plane goes through
    several of them; but there is no bound but the number of cells that all these planes make. *)

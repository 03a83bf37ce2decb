(** Reflex edges of a solid, at which it is not convex, or the pieces of them that are in a cell. *)

type t

val of_surface : Plane.t array -> (int * Homogeneous.t array) array -> t array
(** [of_surface planes polygons] are the reflex edges of the surface. Each convex polygon comes with the index
    of its plane, in front of which is the outside. An edge is found where two polygons have both its corners.
*)

val split : Plane.t -> t array -> t array * t array
(** [split plane notches] are the pieces behind the plane, and those in front of it. Pieces in the plane are
    dropped. *)

(** What counts beside the edges that a plane goes through and those that it cuts in two. *)
type preference =
  | Even  (** that about as many edges are in front as behind; the first of equal planes is taken *)
  | Any  (** nothing; the last of equal planes is taken, as a rule that of a polygon *)

val plane : prefer:preference -> all:int -> Plane.t array -> t array -> Plane.t option
(** [plane ~prefer ~all planes notches] is a plane through one of these reflex edges, or [None] if there are none.
    The solid has [all] of them: where these are many thousands, fewer planes are tried. It is strictly between the
    two polygons at the edge, or the plane of one of them with its orientation. A cut along it leaves convex angles
    at the edge.

    The candidates are planes of polygons, and planes through the ends of an edge and a third corner. From that
    corner an edge of the surface leads to the edge, or a reflex edge elsewhere ends at it. So the numbers are
    as short as in planes of faces. The best candidate goes through many edges, as through those of a furrow
    one after the other, cuts few others in two, and is as [prefer] says. *)

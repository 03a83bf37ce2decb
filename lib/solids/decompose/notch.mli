(** Reflex edges of a solid, at which it is not convex, or what is left of them in a cell. *)

type t

val of_surface : Plane.t array -> (int * Place.t array) array -> t array
(** Of convex polygons, each with the number of its plane, in front of which is the outside. An edge is found where
    two polygons have both its corners. *)

val split : Plane.t -> t array -> t array * t array
(** What is behind the plane, and what is in front of it; what is in the plane is in neither. *)

val plane : Plane.t array -> t array -> Plane.t option
(** [None] if there are none; else a plane through one of them: one that is strictly between the two polygons
    there, or that of one of the two with its front. A cut by it leaves convex angles.

    Many are tried: planes of polygons, and those through the ends of an edge and a third corner, to which an
    edge of the surface goes from there, or at which a reflex edge elsewhere ends. So the numbers are as short
    as in planes of faces. What is taken goes through many, as through the edges of a furrow one after the
    other, cuts few others in two, and has about as many in front as behind. *)

(** The boundary of a polygon as one cycle: for a polygon with holes, that of what is left when cuts join each of
    them to the rest. Both ends of a cut are then twice on it, with an angle of their own at each time. *)

type t = private { grid : Grid.t; at : int array  (** the point at each position, counter-clockwise *) }

val of_polygon : Polygon.t -> t
(** Each hole is joined by the shortest cut between corners that there is. *)

val sees : t -> int -> int -> bool
(** Two positions: the open segment between their points is inside the polygon, touches neither edges nor corners,
    and leaves both corners into the angles of these positions. *)

val reflex : t -> int -> bool
(** The angle is more than a straight one. *)

(** The boundary of a polygon as one cycle. In a polygon with holes, cuts join each hole to the rest. Both ends
    of a cut are then twice on the cycle, each time with an angle of their own. *)

type t = private { grid : Grid.t; at : int array  (** the point at each position, counter-clockwise *) }

val of_polygon : Polygon.t -> t
(** The cycle of a polygon. Each hole is joined by the shortest cut between corners that exists. *)

val sees : t -> int -> int -> bool
(** [sees c i j] is true if a diagonal can join the positions i and j. The open segment between their points is
    inside the polygon and touches neither edges nor corners. It leaves both corners into the angles of these
    positions. *)

val reflex : t -> int -> bool
(** [reflex c i] is true if the angle at position i is more than a straight one. *)

(** The boundary of a polygon as one cycle. In a polygon with holes, cuts join each hole to the rest. Both ends
    of a cut are then twice on the cycle, each time with an angle of their own. *)

type t = private { grid : Grid.t; at : int array  (** the point at each position, counter-clockwise *) }

val of_polygon : Polygon.t -> t
(** The cycle of a polygon. Each hole is joined by the shortest cut between corners that exists. *)

(** What is on the open segment between two positions. *)
type view =
  | Open  (** the inside of the polygon alone, no edges or corners, so that a diagonal can join the positions *)
  | Along  (** corners or edges, which are not crossed *)
  | Closed
  (** something outside of the polygon; or the segment is a point. No convex piece has both as corners. *)

val view : t -> int -> int -> view
(** [view c i j] is what is between the positions i and j. At both ends, only the angle of the position counts as
    inside. *)

val reflex : t -> int -> bool
(** [reflex c i] is true if the angle at position i is more than a straight one. *)

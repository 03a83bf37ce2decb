(** The point of B - A nearest to the origin, guessed in floats by the method of Gilbert, Johnson and Keerthi.
    B - A is the set of all vectors from a point of A to one of B at the instant of the flight. Nothing here is
    proved. *)

type t = {
  flight : Flight.t;
  p : float array;  (** the corners, three coordinates each, as at the last search *)
  va : int array;
  vb : int array;  (** the vertices of A and of B that they are of *)
  weight : float array;  (** of the corners in the nearest point; positive, with sum 1 up to rounding *)
  n : float array;  (** the unit vector from the origin towards the set at its nearest *)
  shift : float array;  (** what the set is displaced by during {!miss}; else 0 *)
  mutable count : int;  (** of corners; 0 before the first search *)
}

val make : Flight.t -> t
(** A search for the flight, without corners. *)

type found =
  | Apart of float  (** at this distance, in the direction of [n]; there are at most three corners *)
  | Near  (** too near to tell, or the origin lies in the set *)

val search : t -> found
(** The search at the current instant of the flight. It begins with the corners found last. *)

val between : Flight.t -> float array -> unit
(** [between flight x] sets the three coordinates of [x] to the vector from a point well inside A to one well
    inside B. *)

val miss : t -> float -> float
(** [miss s k] searches in the set displaced by k times the vector {!between}. It returns the distance from the
    origin of the point found: a point of the displaced set, up to an error of [Flight.epsilon] (1 + k) S. The
    search ends as soon as that is within [Flight.epsilon] S. *)

val depth : t -> float
(** The radius of a ball around the vector {!between} that lies in the set. *)

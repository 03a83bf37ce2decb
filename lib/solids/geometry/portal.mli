(** Portals: the place where a line enters the obstacle A - B of two solids, or a plane between the two,
    searched in floats. The vertices and the direction found are a guess. {!Support_proof} proves them, over
    integers where floats cannot. A wrong guess costs time only. *)

type triangle = { p : Point.t; q : Point.t; r : Point.t }

type edge = { right : Point.t; left : Point.t }
(** Seen along the line, the ray from the centre of the obstacle through the line passes between the two. *)

(** A guess about a line, from its infinite past on. *)
type line =
  | Apart of Shadow.floats  (** this direction seems to separate, and to be orthogonal to the line *)
  | Beside of edge  (** the line seems to pass along or outside of this edge of the silhouette *)
  | Through of { portal : triangle; edge : edge }
  (** the line seems to enter through the portal, which carries a facet; it passes inside of the edge *)
  | Lost

(** A guess about the origin. *)
type place =
  | Apart of Shadow.floats  (** this direction seems to separate *)
  | Inside of triangle  (** the origin seems to be between the centre and this portal *)
  | Facing of triangle  (** this portal seems to carry the facet towards the origin *)
  | Lost

type guess = {
  cast : Question.t -> hasty:bool -> line;
  (** follows the line from behind to where it enters the obstacle; [Apart] only if [hasty] *)
  through : Question.t -> edge -> line;
  (** goes on from [Beside], the edge being no edge of the silhouette: [Through], or nothing is found *)
  locate : Question.t -> hasty:bool -> place;  (** [Apart] only if [hasty] *)
}

val guess : guess
(** Guesses by portal ray-shooting. *)

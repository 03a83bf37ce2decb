(** A solid seen through floats, about its reference point. Every number here is close to an exact one, as said, or
    a bound on exact ones that holds, so that filters can be built on it. *)

open Scc_exact

type floats = { x : float; y : float; z : float }

val floats : Vec.t -> floats
(** Floats within 3 * 2^-53 of the coordinates, relatively; a NaN for a coordinate that is too small for that, an
    infinity for one that is too great. *)

val greatest : floats -> float
(** The greatest size of a coordinate; a NaN if one of them is. *)

val sane : float -> bool
(** Whether a coordinate is 0 or of a size between 2^-120 and 2^120: then no product of a few of them overflows or
    loses digits for being small. False for a NaN. *)

type t = private {
  count : int;  (** vertices *)
  xs : float array;
  ys : float array;
  zs : float array;  (** the coordinates of the vertices, as {!floats} *)
  compass : Compass.t;
  low : floats;
  high : floats;  (** the least and greatest of these *)
  reach : float;  (** no coordinate of a vertex or of the centre is greater in absolute value *)
  cx : float;
  cy : float;
  cz : float;
  (** the centre: a point with these very coordinates, strictly inside if [usable] *)
  inner : float;  (** the ball of this radius about the centre lies inside; [neg_infinity] if not [usable] *)
  outer : float;  (** the ball of this radius about the centre holds the solid *)
  centre : Ivec.t;  (** the centre, exactly, over [centre_denominator] *)
  centre_denominator : Z.t;
  usable : bool;
  (** all coordinates are {!sane}, and the centre is strictly inside *)
}

val make : Ivec.t array -> Z.t -> centroid:Vec.t -> normals:Ivec.t array -> corners:Ivec.t array -> t
(** [make vertices denominator ~centroid ~normals ~corners]: [corners] has a vertex of each face, over the
    denominator too. *)

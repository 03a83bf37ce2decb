(** A solid in floats, relative to its reference point. Each number here is close to an exact one, within the
    stated error, or a proved bound on exact ones. Filters are built on these numbers. *)

open Scc_exact

type floats = { x : float; y : float; z : float }

val floats : Vec.t -> floats
(** Floats within a relative error of 3 * 2^-53 of the coordinates. A coordinate that is too small for that
    gives a NaN, and one that is too great gives an infinity. *)

val greatest : floats -> float
(** The greatest absolute value of a coordinate; a NaN if a coordinate is a NaN. *)

val sane : float -> bool
(** [sane x] is true if x is 0 or its absolute value is between 2^-120 and 2^120. Then no product of a few such
    numbers overflows or loses digits by underflow. It is false for a NaN. *)

type t = private {
  count : int;  (** vertices *)
  xs : float array;
  ys : float array;
  zs : float array;  (** the coordinates of the vertices, as {!val-floats} *)
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
(** [make vertices denominator ~centroid ~normals ~corners] is the solid with the vertices [vertices /
    denominator]. For each face, [normals] has its normal and [corners] one of its vertices, over the
    denominator too. *)

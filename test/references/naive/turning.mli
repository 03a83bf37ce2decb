(** The first time at which two turning bodies interpenetrate, by subdivision of time: slow and plain, a second
    time, to hold the first implementation against. It shares only vectors and rationals with the library. Floats
    guess an axis ({!Turning_guide}); what is said is proved in integers:

    - over a piece of time the interiors are disjoint when along one axis, which turns with the bodies, A stays on
      one side and B on the other: signs of polynomials in time, by their Bernstein coefficients on the piece;
    - at an instant they interpenetrate when they overlap along all separating axes there are (every face, every
      pair of edges). *)

open Scc_exact

(** A point at p about the reference point is at time t at
    centre + t velocity + C(spin (since + t)/2) (arm + turned p), where C(u) is the rotation of the quaternion 1 +
    u and [turned] that of a quaternion w, x, y, z of any length. *)
type body = {
  solid : Naive.solid;  (** about its reference point, before it is turned *)
  turned : Rat.t * Rat.t * Rat.t * Rat.t;
  arm : Vec.t;
  centre : Vec.t;
  velocity : Vec.t;
  spin : Vec.t;
  since : Rat.t;
}

type first =
  | Never
  | Inside  (** they interpenetrate at time 0 *)
  | Within of Rat.t * Rat.t  (** they interpenetrate at the second time; not before the first, doubts aside *)

type answer = {
  doubts : (Rat.t * Rat.t) list;
  (** pieces before [first], as short as can be, over which no axis separates them though they do not
      interpenetrate at the end of any: they touch, or interpenetrate for a moment *)
  first : first;
  given_up : bool;  (** too many doubts, or pieces: nothing is known after the last doubt *)
}

val first : ?finest:int -> body -> body -> span:Rat.t -> answer
(** Over [0, span]; the shortest pieces are span/2^finest (2^42 unless given). *)

val interpenetrate : body -> body -> Rat.t -> bool
(** At a time >= 0. *)

val guide : ?law:Turning_guide.law -> body -> body -> span:Rat.t -> Turning_guide.t

(** Two turning bodies in floats: how far apart they are at a time, and along which axes. Guesses only: {!Turning}
    proves what it uses of them. Time is counted in units of the span, from 0 to 1. *)

(** Along which direction two bodies may be separated: the outward normal of a face of the first, or of the second
    (reversed), or the product of an edge of each. Edges are counted as in {!edges}. *)
type axis = Face_a of int | Face_b of int | Edges of int * int

type candidate = {
  axis : axis;
  reversed : bool;  (** the direction from A to B is the opposite of the axis *)
  corner_a : int;  (** a highest corner of A along the direction *)
  corner_b : int;  (** a lowest corner of B *)
  gap : float;  (** how far B is beyond A along the direction, a unit vector; negative where they overlap *)
}

(** A body about its centre of turning: where the corners are from it at the start of the turn. *)
type body = {
  corners : float array array;
  faces : int array array;
  centre : float array;
  travel : float array;  (** of the centre, over the span *)
  half_spin : float array;
  since : float;
  span : float;
}

(** How a body turns: C(spin (since + t)/2), or at the constant rate that brings it (from [since] = 0) to the same
    angle at the end of the span. *)
type law = Cayley | Uniform

type t

val make : ?law:law -> body -> body -> t

val edges : int array array -> (int * int * int * int) array
(** Of faces as cycles: tail, head, the face on the left, the face on the right; each edge once. *)

val best : t -> float -> int -> candidate list
(** [best g t n]: at most [n] axes with the widest gaps at a time, the widest first. Not empty. *)

val gap : t -> float -> float
(** The widest gap. *)

val faces_gap : t -> float -> float
(** The widest along normals of faces: at most {!gap}, and sooner found. *)

val least : ?samples:int -> (float -> float) -> float * float
(** Where a function of [0, 1] is about least, and its value there. *)

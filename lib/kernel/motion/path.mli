(** The motion of a process between two events: its place, its orientation and the velocities of its points. All
    are known at any instant and as functions of time (rules Time, Turn and Instants). All code that follows
    bodies through time uses this module.

    In the translational calculus a process moves in a straight line. In the rigid calculus its centre of mass
    does, and the process turns about it by the Cayley map. Let w be its spin, r the vector from the centre to a
    point now, and s = since + t. At offset t the point is at (a + b s + c s^2) / (1 + |w|^2 s^2 / 4) from the
    centre, for vectors a, b and c that depend on r and w. All vectors are in the world frame. Offsets t >= 0
    count from now. *)

open Scc_exact
open Scc_rigid
open Scc_calculus

type t

val make : ?for_ever:bool -> Model.t -> State.process -> t
(** [make m p] is the path of [p] from now on, until the end of its present turn if it turns. With
    [~for_ever:true] it is the path over the ray of a quiescent network, and what changes from turn to turn is
    {!Not_followed}. The function is cheap: masses and curves are computed at their first use. *)

val model : t -> Model.t
(** The model of the process. *)

val process : t -> State.process
(** The process as it is now, at t = 0. *)

(** {1 At an instant} *)

val at : t -> Rat.t -> State.process
(** [at p t] is the process with the places and orientations of its leaves at offset [t]. Behaviours and the
    split clock stay as they are now. *)

val motions : t -> State.leaf -> (Motion.t * Rat.t) list
(** The motion of each part of a leaf, with an upper bound on the distance of the part's points from the centre
    of mass of the process. *)

(** {1 As functions of time} *)

(** A number along a path. *)
type curve =
  | Steady of Rat.t
  | Quotient of Polynomial.t * Polynomial.t  (** polynomials in t; the denominator vanishes nowhere *)
  | Not_followed  (** it changes from turn to turn, on a path [for_ever] *)

val now : curve -> Rat.t option
(** The value at t = 0; [None] for {!Not_followed}. *)

val coordinate : t -> Vec.axis -> Vec.t -> curve
(** [coordinate p axis x] is the coordinate along [axis] of the point of the process that is now at [x]. *)

val velocity : t -> Vec.axis -> Vec.t -> curve
(** [velocity p axis x] is the component along [axis] of the velocity of the point that is now at [x]. The
    velocity is v + w x r, where v is the velocity of the centre of mass and r the vector from it to the point.
*)

val speed2 : t -> Vec.t -> curve
(** [speed2 p x] is the square of the speed of the point that is now at [x]. *)

val distance2 : t -> Vec.t -> t -> Vec.t -> curve
(** [distance2 p x q y] is the squared distance of the point of [p] that is now at [x] from the point of [q] that
    is now at [y]. *)

val spin : t -> Vec.axis -> curve
(** [spin p axis] is the component along [axis] of the spin, in radians per unit of time. It is constant within a
    turn. *)

val spin2 : t -> curve
(** The square of the magnitude of the spin. It is constant within a turn. *)

val momentum : t -> Vec.axis -> curve
(** [momentum p axis] is the component along [axis] of the linear momentum; 0 for a fixed process. *)

val angular : t -> Vec.axis -> curve
(** [angular p axis] is the component along [axis] of the angular momentum about the origin of the world; 0 for a
    fixed process. Its part about the centre of mass turns with the body, or is constant for a free body. *)

val energy : t -> curve
(** The kinetic energy; 0 for a fixed process. *)

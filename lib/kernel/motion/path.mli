(** What a process does between two events, while nothing happens to it: where it is, how it is turned and how
    fast its points are, at any instant and as functions of time (rules Time, Turn and Instants). Whoever follows
    bodies through time asks here.

    In the translational calculus a process goes in a straight line. In the rigid one its centre of mass does, and
    it turns about it by the Cayley map: what is at r from the centre now is at
    (a + b s + c s^2) / (1 + |w|^2 s^2 / 4) from it later, with s = since + t and its spin w. World frame; offsets
    t >= 0 count from now. *)

open Scc_exact
open Scc_rigid
open Scc_calculus

type t

val make : ?for_ever:bool -> Model.t -> State.process -> t
(** The path from where the process is, until the end of its present turn if it turns; or [for_ever], over the ray
    of a quiescent network: then what turn after turn would change is {!Not_followed}. Cheap: what is not asked for
    is not computed. *)

val model : t -> Model.t

val process : t -> State.process
(** As it is now. *)

(** {1 At an instant} *)

val at : t -> Rat.t -> State.process
(** The process with the places and orientations that its leaves have then; behaviours and the split clock stay as
    they are now. *)

val motions : t -> State.leaf -> (Motion.t * Rat.t) list
(** For each part of a leaf its motion, and an upper bound on the distance of its points from what it turns
    about. *)

(** {1 As functions of time} *)

(** A number along a path. *)
type curve =
  | Steady of Rat.t
  | Quotient of Polynomial.t * Polynomial.t  (** of t; the denominator vanishes nowhere *)
  | Not_followed

val now : curve -> Rat.t option
(** The value at t = 0; [None] of what is not followed. *)

val coordinate : t -> Vec.axis -> Vec.t -> curve
(** Of the point of the process that is now at a place. *)

val velocity : t -> Vec.axis -> Vec.t -> curve
(** Of that point: v + w x r, where v is the velocity of the centre of mass. *)

val speed2 : t -> Vec.t -> curve
(** The square of that velocity. *)

val distance2 : t -> Vec.t -> t -> Vec.t -> curve
(** The squared distance of a point of one process from one of another. *)

val spin : t -> Vec.axis -> curve
val spin2 : t -> curve

val momentum : t -> Vec.axis -> curve
(** This and the next are zero for a fixed process. *)

val angular : t -> Vec.axis -> curve
(** The angular momentum about the origin of the world. That of the turn is turned as the body is. *)

val energy : t -> curve
(** Kinetic. *)

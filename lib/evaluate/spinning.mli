(** The curves that the points of a rigid model follow between events (rules Turn and Instants): rational
    functions of the offset t from now on. A process turns about its centre of mass by the Cayley map, so that what
    is at r from the centre now is at (a + b s + c s^2) / (1 + |w|^2 s^2 / 4) from it later, with s = since + t and
    its spin w. *)

open Scc_exact
open Scc_calculus
open Scc_property

type t

val make : ?for_ever:bool -> Model.t -> State.process -> t
(** A process of a rigid model, until its present turn ends; or [for_ever], over the ray of a quiescent network:
    then what turn after turn would change is [Undefined]. *)

val coordinate : t -> Property.axis -> Vec.t -> Value.t
(** Of the point of the process that is now at a place. *)

val velocity : t -> Property.axis -> Vec.t -> Value.t
(** Of that point: v + w x r, where v is the velocity of the centre of mass. *)

val speed2 : t -> Vec.t -> Value.t
(** The square of that velocity. *)

val distance2 : t -> Vec.t -> t -> Vec.t -> Value.t
(** The squared distance of a point of one process from one of another. *)

val angular : t -> Property.axis -> Value.t
(** The angular momentum about the origin of the world; zero for a fixed process. That of the turn is turned as
    the body is. *)

val energy : t -> Value.t
(** Kinetic, which does not change during a turn; zero for a fixed process. *)

val spin : t -> Property.axis -> Value.t
val spin2 : t -> Value.t

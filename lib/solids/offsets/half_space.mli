(** Rules Contact, Approach and Ftoc as linear constraints on an offset whose coordinates are forms over
    variables. The conditions are those of {!Scc_geometry.Side}, at each half-space that bounds a convex set of
    offsets. *)

open Scc_exact
open Scc_geometry
open Scc_polyhedra

(** A half-space, as an offset sees it that moves at a constant velocity. *)
type t = {
  index : int;  (** its place among all that bound the set *)
  room : Linear.t;  (** how far the offset is inside, in units of the normal: negative beyond *)
  speed : Rat.t;  (** normal . velocity: how much room is lost in a unit of time *)
}

(** {1 Making} *)

val still : Obstacle.t -> Place.t -> t list
(** [still o offset] has the half-space of each facet of [o], for an offset at rest. *)

val moving : Obstacle.t -> Place.t -> Vec.t -> t list
(** [moving o offset velocity] has the half-space of each facet of [o]. Offset and velocity are those of the second
    solid from the first. *)

val of_closed : Polyhedron.t -> Place.t -> Vec.t -> t list
(** [of_closed set offset velocity] has the half-spaces whose intersection is the closure of [set], a polyhedron of
    dimension 3. *)

(** {1 Conditions at one instant} *)

val needs : Side.need -> t -> Constraint.t
(** [needs need h] holds where the room in [h] is as needed. *)

val on_border : t -> Constraint.t
(** [on_border h] holds where there is no room in [h], and the offset is not beyond it. *)

val contact : t list -> Constraint.t list
(** The closed bodies have a common point where all of these hold ({!Scc_geometry.Side.contact}). *)

val overlap : t list -> Constraint.t list
(** The interiors have a common point where all of these hold ({!Scc_geometry.Side.overlap}). *)

val collision : t list -> Constraint.t list
(** The interiors have a common point right after now where all of these hold ([Side.collision]). Where bodies
    do not interpenetrate now, they collide there. *)

(** {1 Time} *)

val after : Linear.t -> t -> t
(** [after time h] is [h] as the offset sees it after that time. *)

val crossing : t -> Linear.t
(** The time at which room is 0, perhaps a past one. The speed must not be 0. *)

(** The half-spaces by {!Scc_geometry.Side.times}, in their order. *)
type passage = {
  entered : t list;  (** the offset is in them after their crossing *)
  left : t list;  (** the offset is in them before their crossing *)
  along : t list;  (** the offset is in them always or never *)
}

val passage : t list -> passage
(** The half-spaces by how the offset passes them. *)

val first_collision : passage -> limit:Linear.t option -> Linear.t list * Constraint.t list
(** Rule Ftoc, where bodies do not interpenetrate now. They collide, now or later and not after the limit, where
    all of the constraints hold. The time is the greatest of the forms, the crossings of what is entered. *)

val first_meeting : passage -> now:Linear.t -> limit:Linear.t option -> Linear.t list * Constraint.t list
(** [first_meeting passage ~now ~limit] is for closed sets, as in reading I-33. The offset is in the set at some
    time from [now] on, and not after the limit, where all of the constraints hold. The first such time is the
    greatest of the forms. [now] is the form 0. *)

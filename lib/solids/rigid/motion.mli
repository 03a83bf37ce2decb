(** A convex solid that moves and turns over a movement step (rule Turn). World frame; times t >= 0 count from
    now.

    The solid turns about a centre that moves in a straight line: a point of the solid that is at p about the
    reference point of {!Scc_geometry.Solid.t} is at

    x(t) = centre + t velocity + C(spin (since + t)/2) (arm + turned p)

    with the Cayley map C(u), the rotation by 2 atan|u| about u. C is not additive in t: a turn that began
    [since] ago goes on as it began. The angular velocity at t is spin / (1 + |u|^2), and so never exceeds
    |spin|. *)

open Scc_exact
open Scc_geometry

type t = {
  solid : Solid.t;
  turned : Quaternion.t;  (** how the solid was turned at the start of the turn *)
  arm : Vec.t;  (** from the centre to the solid's reference point at the start of the turn *)
  centre : Vec.t;  (** the present place of the point that the solid turns about *)
  velocity : Vec.t;
  spin : Vec.t;  (** radians per unit of time, right-handed *)
  since : Rat.t;  (** >= 0: how long ago the turn began *)
}

val turns : t -> bool
(** [turns m] is true if the spin is not zero. *)

val rotation : t -> Rat.t -> Quaternion.t
(** [rotation m t] is the rotation of the solid at the time [t]. *)

val reference : t -> Rat.t -> Vec.t
(** [reference m t] is the place of the solid's reference point at the time [t], in the world. *)

val point : t -> Rat.t -> Vec.t -> Vec.t
(** [point m t p] is the place at the time [t] of the point of the solid that is at [p] relative to the
    reference point. *)

val vertices : t -> Rat.t -> Vec.t array
(** [vertices m t] are the places of the vertices at the time [t], in the world. *)

val placed : t -> Rat.t -> Solid.t * Vec.t
(** [placed m t] is the solid, turned as it is at the time [t], and the place of its reference point. These are
    the arguments of the queries of {!Scc_geometry}. Not cheap: the turned solid is made anew. *)

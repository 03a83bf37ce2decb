(** A convex solid that moves and turns over a movement step (rule Turn). World frame; times t >= 0 count from now.

    The solid turns about a centre that moves in a straight line:
    a point of the solid that is at p about the reference point of {!Solid.t} is at

    x(t) = centre + t velocity + C(spin (since + t)/2) (arm + turned p)

    with the Cayley map C(u), the rotation by 2 atan|u| about u. C is not additive in t: a turn that began [since]
    ago goes on as it began. The angular velocity at t is spin / (1 + |u|^2), hence nowhere greater than |spin|. *)

open Scc_exact
open Scc_geometry

type t = {
  solid : Solid.t;
  turned : Quaternion.t;  (** how the solid was turned at the start of the turn *)
  arm : Vec.t;  (** from the centre to the solid's reference point at the start of the turn *)
  centre : Vec.t;  (** what the solid turns about: where it is now *)
  velocity : Vec.t;
  spin : Vec.t;  (** radians per unit of time, right-handed *)
  since : Rat.t;  (** >= 0: how long ago the turn began *)
}

val turns : t -> bool
(** The spin is not zero. *)

val rotation : t -> Rat.t -> Quaternion.t
(** How the solid is turned at a time. *)

val reference : t -> Rat.t -> Vec.t
(** Where the solid's reference point is. *)

val point : t -> Rat.t -> Vec.t -> Vec.t
(** [point m t p]: where the point of the solid is that is at [p] about the reference point. *)

val vertices : t -> Rat.t -> Vec.t array
(** Where the vertices are. *)

val placed : t -> Rat.t -> Solid.t * Vec.t
(** The solid, turned as it is at a time, and where its reference point is: what the queries of {!Scc_geometry}
    take. Not cheap: the turned solid is made anew. *)

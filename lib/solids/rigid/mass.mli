(** Masses of rigid bodies and what they keep when they move: momentum, angular momentum and kinetic energy
    (rule Mass). World frame; exact. *)

open Scc_exact

(** A uniform solid of some mass. *)
type part = { body : Placed.t; mass : Rat.t  (** positive *) }

type t = {
  mass : Rat.t;  (** positive *)
  centre : Vec.t;  (** of mass *)
  inertia : Mat.t;  (** about the centre of mass, along the axes of the world: symmetric, positive definite *)
}

val of_part : part -> t
(** The inertia of a turned solid is R I R^T. *)

val join : t list -> t
(** The whole of at least one body, by the parallel axis theorem. *)

val of_parts : part list -> t
(** The compound of at least one part. *)

val inertia_about : t -> Vec.t -> Mat.t
(** The inertia about any point (the parallel axis theorem). *)

val inverse_inertia : t -> Mat.t

val scale : t -> Rat.t
(** The greatest power of two that is at most the trace of the inertia, which does not change as the body turns. *)

val turn_rate : t -> Vec.t -> Vec.t
(** The spin of a body with this angular momentum about its centre. *)

(** {1 Of a body whose centre has a velocity and that spins} *)

val momentum : t -> velocity:Vec.t -> Vec.t

val angular_momentum : t -> velocity:Vec.t -> spin:Vec.t -> about:Vec.t -> Vec.t
(** About a point at rest. *)

val energy : t -> velocity:Vec.t -> spin:Vec.t -> Rat.t
(** Kinetic. *)

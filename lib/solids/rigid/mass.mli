(** Masses of rigid bodies, and their conserved quantities: momentum, angular momentum and kinetic energy (rule
    Mass). World frame; exact. *)

open Scc_exact

(** A uniform solid of some mass. *)
type part = { body : Placed.t; mass : Rat.t  (** positive *) }

type t = {
  mass : Rat.t;  (** positive *)
  centre : Vec.t;  (** of mass *)
  inertia : Mat.t;  (** about the centre of mass, along the axes of the world: symmetric, positive definite *)
}

val of_part : part -> t
(** The mass, the centre and the inertia of one part. The inertia of a turned solid is R I R^T. *)

val join : t list -> t
(** The mass of the whole of at least one body (a bug otherwise), by the parallel axis theorem. *)

val of_parts : part list -> t
(** The mass of the compound of at least one part. *)

val inverse_inertia : t -> Mat.t
(** The inverse of the inertia about the centre of mass. *)

val scale : t -> Rat.t
(** The greatest power of two that is at most the trace of the inertia. It is constant as the body turns. *)

val turn_rate : t -> Vec.t -> Vec.t
(** [turn_rate b l] is the spin of a body with the angular momentum [l] about its centre. *)

(** {1 Of a body whose centre has a velocity and that spins} *)

val momentum : t -> velocity:Vec.t -> Vec.t
(** The mass times the velocity of the centre. *)

val angular_momentum : t -> velocity:Vec.t -> spin:Vec.t -> about:Vec.t -> Vec.t
(** The angular momentum about a point at rest. *)

val energy : t -> velocity:Vec.t -> spin:Vec.t -> Rat.t
(** The kinetic energy, of translation and of rotation. *)

(** The law [diffuse]: kicks along a lattice, and of the orientation (rule Diffuse). *)

open Scc_exact
open Scc_calculus

(** The length of the kicks of a law, and their spin. *)
type lattice = {
  kick : Rat.t;
  spread : Rat.t;  (** the least square of a kick: 2 times the timestep, times the sum of the constants *)
  chosen : bool;  (** true if the model does not give the kick: it is {!least_kick} *)
  spin : Rat.t option;
  (** the spin of a kick of the orientation, in radians per unit of time; [None] if the law gives no spin *)
}

val least_kick : timestep:Rat.t -> Vec.t -> Rat.t
(** [least_kick ~timestep d] is the least power of two that is long enough for the diffusion constants [d] along
    the axes. The constants are lengths squared per time and not negative. It is 1 if all are 0. *)

val spread : timestep:Rat.t -> Vec.t -> Rat.t
(** [spread ~timestep d] is the mean of the squared displacement of a step. No square of a kick is less. *)

val kicks : timestep:Rat.t -> drift:Law.vector -> kick:Rat.t -> Vec.t -> (Law.kick list, Rat.t) result
(** [kicks ~timestep ~drift ~kick d] is a choice of velocities for one movement step. Its displacements have the
    mean [drift] * [timestep], the variances 2 [d] [timestep] along the axes, and no covariances. Each choice is
    a kick of the length [kick] > 0 along one axis, in either direction, or none.

    An error is the least square of a kick that is long enough. *)

val turns : timestep:Rat.t -> Vec.t -> (Rat.t * (Vec.t * Rat.t) list, Rat.t) result
(** [turns ~timestep c] is the spin of a kick, and a choice of spins for one movement step with their
    probabilities, which sum to 1. Each is about one axis of the world, in either direction, or zero. The mean of
    the rotations of a step that nothing cuts short is a diagonal matrix: 1 - ([c].y + [c].z) [timestep] for the x
    axis, and likewise for the others. The constants [c] are inverse times and not negative.

    An error is the greatest sum of the constants that is possible with this timestep. *)

val spun : Law.kick list -> (Vec.t * Rat.t) list -> Law.kick list
(** [spun kicks spins] is the choice of a velocity of [kicks], and of a spin independently of it. *)

(** The law [diffuse]: kicks along a lattice (rule Diffuse). *)

open Scc_exact
open Scc_calculus

(** The length of the kicks of a law. *)
type lattice = {
  kick : Rat.t;
  spread : Rat.t;  (** the least square of a kick: 2 times the timestep, times the sum of the constants *)
  chosen : bool;  (** true if the model does not give the kick: it is {!least_kick} *)
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

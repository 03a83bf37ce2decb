(** The law [diffuse]: kicks along a lattice (rule Diffuse). *)

open Scc_exact
open Scc_calculus

val least_kick : timestep:Rat.t -> Vec.t -> Rat.t
(** The least power of two that is long enough for diffusion constants (squares of lengths per time, along the
    axes; none of them negative) at this length of movement steps; 1 where all are 0. *)

val kicks : timestep:Rat.t -> drift:Law.vector -> kick:Rat.t -> Vec.t -> (Law.kick list, Rat.t) result
(** A choice whose displacements in one movement step have the mean [drift] * [timestep] and the variances 2 D
    [timestep] along the axes, with D the diffusion constant of each, and no covariances: by one kick of this
    length (positive) along an axis, this way or that, or none. An error tells the least square of a kick that is
    long enough. *)

(** The fixed point of diffusion on the pixels of a shape: the discrete Poisson equation

    4 v(p) - v(left) - v(right) - v(above) - v(below) = 4 s(p),

    with v = 0 outside of the shape and strengths s >= 0. It is solved in integers by successive over-relaxation
    (Young), the same on all machines, and how far the result may be from the exact solution is proved by what is
    left over in the equations: the exact solution differs from [v] by at most {!bound} times the greatest of these
    (the rule book's section on icons). *)

open Scc_exact

type t = {
  values : int array;  (** of each pixel of the rectangle, in units of 2{^-bits} times the greatest strength *)
  bits : int;
  error : int;  (** in those units: the exact solution is nowhere farther away *)
}

val bound : Silhouette.t -> int
(** Eight times a bound of the solution for 4 s = 1: (m + 1){^2}, with m the smaller one of width and height. *)

val solve : progress:(float -> unit) -> Silhouette.t -> strength:(int -> Rat.t) -> greatest:Rat.t -> t
(** [strength] of the pixel of an index, from 0 to [greatest], which is more than 0 and is reached. Where the
    shape and the strengths are symmetric, the values are symmetric, exactly. [progress] is told which share of the
    work is done, at most. *)

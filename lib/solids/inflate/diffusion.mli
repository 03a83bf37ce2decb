(** The fixed point of diffusion on the pixels of a shape: the discrete Poisson equation

    4 v(p) - v(left) - v(right) - v(above) - v(below) = 4 s(p),

    with v = 0 outside of the shape and strengths s >= 0. It is solved in integers by successive
    over-relaxation (Young), with the same result on all machines. The error is proved from the residuals of
    the equations. The exact solution differs from [v] by at most (m + 1){^2} / 8 times the greatest residual (the
    rule book's section on icons). *)

open Scc_exact

type t = {
  values : int array;  (** of each pixel of the rectangle, in units of 2{^-bits} times the greatest strength *)
  bits : int;
  error : int;  (** in those units: a bound on the distance to the exact solution, everywhere *)
}

val solve : progress:(float -> unit) -> Silhouette.t -> strength:(int -> Rat.t) -> greatest:Rat.t -> t
(** [solve ~progress shape ~strength ~greatest] is the fixed point on the pixels of the shape. The function
    [strength] gives the strength of the pixel of an index, from 0 to [greatest], which is positive and is
    reached. If the shape and the strengths are symmetric, the values are symmetric, exactly. [progress] gets
    an upper bound on the share of the work that is done. *)

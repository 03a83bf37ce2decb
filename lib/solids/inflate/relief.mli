(** The heights of an inflated shape over the centres of its pixels: small numbers, and how far they are from the
    exact ones, which is proved. *)

open Scc_exact

(** From the fixed point v of diffusion ({!Diffusion}) to heights, in pixels. Over a disc of radius r and
    strength 1 both are highest by about r. *)
type profile =
  | Diffused  (** v/r, with {!field:t.radius} r: a paraboloid over a disc *)
  | Round  (** the root of v: a sphere over a disc *)

val quanta : int
(** 256: heights are multiples of 1/256 of a pixel. *)

type t = {
  shape : Silhouette.t;
  heights : int array;
  (** of the pixels of the rectangle, in quanta: 0 outside of the shape, and more than 0 in it *)
  radius : Rat.t;  (** in pixels *)
  highest : int;  (** in quanta *)
  off : Rat.t;  (** no height is farther than this, in pixels, from what it is exactly *)
}

val root_up : Z.t -> Z.t
(** The least integer whose square is not less. *)

val most : int
(** Shapes higher than this are refused, in pixels: 2{^16}. *)

val make : profile -> Silhouette.t -> Diffusion.t -> greatest:Rat.t -> t option
(** [greatest] is the greatest strength. [None] when it would be too high. *)

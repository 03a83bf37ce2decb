(** The heights of an inflated shape over the centres of its pixels, as small numbers with a proved bound on
    their error. *)

open Scc_exact

(** From the fixed point v of diffusion ({!Diffusion}) to heights, in pixels. Over a disc of radius r and
    strength 1 both are highest by about r. *)
type profile =
  | Diffused  (** v/r, with {!field:t.radius} r: a paraboloid over a disc *)
  | Round  (** the root of v: a sphere over a disc *)

val quanta : int
(** The number of quanta in a pixel, 256: heights are multiples of 1/256 of a pixel. *)

type t = {
  shape : Silhouette.t;
  heights : int array;
  (** of the pixels of the rectangle, in quanta: 0 outside of the shape, and more than 0 in it *)
  radius : Rat.t;  (** in pixels *)
  highest : int;  (** in quanta *)
  off : Rat.t;  (** a bound on the error of all heights, in pixels *)
}

val root_up : Z.t -> Z.t
(** The least integer whose square is at least the number, which is not negative. *)

val most : int
(** The greatest height of a shape that is not refused, in pixels: 2{^16}. *)

val make : profile -> Silhouette.t -> Diffusion.t -> greatest:Rat.t -> t option
(** [make profile shape v ~greatest] are the heights for the fixed point [v], where [greatest] is the greatest
    strength. [None] if one is greater than {!most}. *)

val part : t -> Silhouette.t -> t
(** [part r piece] are the heights of a piece of the shape. *)

val on_plate : t -> margin:int -> plate:int -> t
(** [on_plate r ~margin ~plate] are the heights on a plate under the shape ({!Silhouette.surrounded}), whose own
    height is [plate] quanta, more than 0. *)

(** The places of the points of a view on the paper, in pixels, with y downwards. *)

open Scc_exact

(** A drawing with its scale. *)
type t = private {
  width : int;  (** of the drawing, with its margin *)
  height : int;
  unit_length : Rat.t;  (** in pixels *)
  place : Ivec.t -> Rat.t * Rat.t;  (** the place of a point as in {!Convex} *)
}

val make : Camera.t -> width:int -> margin:int -> top:int -> Ivec.t list -> t
(** [make camera ~width ~margin ~top points] is the largest drawing of all points, of which there is at least
    one, within the margins. It is [width] wide and at most four thirds as high. [top] pixels are kept free
    above. *)

val framed :
  width:int ->
  height:int ->
  top:int ->
  middle:Rat.t * Rat.t ->
  half:Rat.t * Rat.t ->
  unit_length:Rat.t ->
  t
(** A drawing of that size, below [top] free pixels, around the point [middle] of the view: so much of the view as
    [half] is between the middle and its right side, and its upper side. *)

val bar : t -> most:int -> Rat.t
(** [bar t ~most] is a round length: the greatest of 1, 2 or 5 times a power of ten that takes at most [most]
    pixels. *)

(** How what is seen of solids is painted. *)

open Scc_exact
open Scc_svg

(** Of all of a picture. *)
type t = {
  camera : Camera.t;
  origin : Ivec.t;  (** what of space is at (0, 0) of the view *)
  canvas : Canvas.t;
  hidden : Hidden.t;
  stroke : float;  (** how wide edges are, in pixels; outlines are half as wide again *)
  faces : int list array;  (** of each solid, indices into the view *)
  edges : int list array;
}

val make : Camera.t -> origin:Ivec.t -> Canvas.t -> Hidden.t -> t
(** Edges are thinner where solids are small. *)

val point : t -> Vec.t -> Ivec.t
(** Where a point of space is in the view. *)

val place : t -> Vec.t -> Rat.t * Rat.t
(** On the paper. *)

val shows : t -> Vec.t -> bool
(** Nothing is in front of the point. *)

val shade : t -> Palette.rgb -> View.face -> Palette.rgb
(** The colour of a face: lighter above and to the left. *)

val region : t -> Convex.t list -> string
(** The data of a path: what these pieces cover. *)

val lines : t -> (Ivec.t * Ivec.t) list -> string
(** Of one that is stroked. *)

val ink : Palette.rgb -> Palette.rgb
(** Of the edges of what has this colour. *)

val solid : t -> Palette.rgb -> int -> string list
(** What is seen of a solid in a colour: its faces, and over them its edges. Nothing if it is hidden. *)

val pixels : float -> string
(** A number of an attribute, with at most two places. *)

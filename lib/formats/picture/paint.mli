(** The painting of visible solids. *)

open Scc_exact
open Scc_svg

(** The camera, canvas and visible parts of a whole picture. *)
type t = {
  camera : Camera.t;
  origin : Ivec.t;  (** the point of space at (0, 0) of the view *)
  canvas : Canvas.t;
  hidden : Hidden.t;
  stroke : float;
  (** the scale of line widths, from 0.25 to 1: times 0.8 pixels for inner edges, and 1.3 pixels for outlines *)
  faces : int list array;  (** for each solid, the indices of its faces in the view *)
  edges : int list array;
}

val make : Camera.t -> origin:Ivec.t -> Canvas.t -> Hidden.t -> t
(** A picture of these visible parts. Lines are thinner if solids are small on the paper. *)

val place : t -> Vec.t -> (Rat.t * Rat.t) option
(** The place of a point of space on the paper; [None] if it is not in front of the eye of the camera. *)

val shows : t -> Vec.t -> bool
(** [shows t p] is true if nothing, except glass, is in front of the point [p] of space. *)

val shade : t -> Palette.rgb -> View.face -> Palette.rgb
(** The colour of a face, from the colour of its solid: lighter if it faces up and to the left. *)

val region : t -> Convex.t list -> string
(** The path data of the region that these pieces cover. *)

val lines : t -> (Ivec.t * Ivec.t) list -> string
(** The path data of these segments, for a stroke. *)

val ink : Palette.rgb -> Palette.rgb
(** The colour of the edges of solids of this colour. *)

val solid : t -> Palette.rgb -> int -> string list
(** The visible part of a solid in a colour: its faces, and its edges over them. Nothing if it is hidden. What
    is behind glass shines through. *)

val pixels : float -> string
(** A number of an attribute, with at most two decimals. *)

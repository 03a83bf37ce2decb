(** The camera of the page of [scc view]: it looks at a point from a distance, in perspective or not. *)

open Scc_exact

(** The camera as a link of the page has it. *)
type t = {
  at : Vec.t;  (** the point in the middle *)
  distance : Rat.t;  (** from this point to the eye; positive *)
  turn : Rat.t;  (** around the axis that points up, from the front to the right, in radians *)
  height : Rat.t;  (** above the floor, in radians, between two right angles *)
  parallel : bool;  (** without perspective *)
  up : Vec.axis;  (** the axis that points up *)
  aspect : Rat.t;  (** the width of the picture over its height; positive *)
}

val camera : t -> Camera.t
(** The viewpoint. Its direction is that of the angles within 2{^-22}. *)

val canvas : t -> Camera.t -> origin:Ivec.t -> width:int -> top:int -> Canvas.t
(** [canvas t (camera t) ~origin ~width ~top] shows as much as the page does, [width] wide, below [top] free
    pixels. The scale is that at the point in the middle. *)

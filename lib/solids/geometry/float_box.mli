(** Boxes with edges along the axes, in floats that are rounded outward. Each contains the exact box that it
    represents. So boxes that are apart here prove that the exact boxes are apart. Coordinates may be infinite.
*)

open Scc_exact

type t

val down : Rat.t -> float
(** A float at most the number; never [infinity]; the number itself if it is a float. *)

val up : Rat.t -> float
(** A float at least the number; never [neg_infinity]; the number itself if it is a float. *)

val of_corners : Vec.t -> Vec.t -> t
(** [of_corners low high] is the box with these least and greatest corners, rounded outward. *)

val at : Vec.t -> t -> t
(** [at p b] is the box [b], which is relative to a point, when that point is at [p]. *)

val swept : Vec.t -> until:float -> t -> t
(** [swept v ~until b] contains the box at all times from 0 to [until] > 0 when it moves with velocity [v]. *)

val make : low:float array -> high:float array -> t
(** [make ~low ~high] is the box with these coordinates of its corners, none of which is a NaN. *)

val low : t -> int -> float
(** [low b axis] is the least coordinate along an axis, 0 to 2. *)

val high : t -> int -> float
(** [high b axis] is the greatest coordinate along an axis, 0 to 2. *)

val meet : t -> t -> bool
(** [meet a b] is true if the closed boxes have a common point. *)

val hull : t array -> t
(** The least box that contains all boxes, of which there is at least one. *)

val equal : t -> t -> bool
(** [equal a b] is true if all coordinates are the same. *)

val extent : t -> float
(** The length of the longest edge; infinite or a NaN if a coordinate is infinite. *)

(** Boxes with edges along the axes, in floats that are rounded outward: each holds the exact box that it stands
    for, so that two exact boxes that meet are never seen as apart. Coordinates may be infinite. *)

open Scc_exact

type t

val down : Rat.t -> float
(** A float at most the number; never [infinity]; 0 for 0. *)

val up : Rat.t -> float
(** A float at least the number; never [neg_infinity]; 0 for 0. *)

val of_corners : Vec.t -> Vec.t -> t
(** From the least and the greatest corner. *)

val at : Vec.t -> t -> t
(** The box, given about a point, when that is at a place. *)

val swept : Vec.t -> until:float -> t -> t
(** Holds the box wherever it is from now to a time, [until] > 0, with a velocity. *)

val make : low:float array -> high:float array -> t
(** From the coordinates of the corners; none is a NaN. *)

val low : t -> int -> float
(** The least coordinate along an axis, 0 to 2. *)

val high : t -> int -> float

val meet : t -> t -> bool
(** Whether the closed boxes have a point in common. *)

val hull : t array -> t
(** Holds all of them, of which there is one at least. *)

val equal : t -> t -> bool

val extent : t -> float
(** The length of the longest edge; infinite or a NaN when a coordinate is infinite. *)

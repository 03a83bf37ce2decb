(** Points of the plane as integers, for fast exact signs. *)

open Scc_exact

type point = { x : Rat.t; y : Rat.t }

val seen_along : Vec.t -> Vec.t -> point
(** [seen_along n v] is the place of [v] in a plane with the normal [n]: what is counter-clockwise about [n] is so
    in the plane. *)

type t
(** Points by their numbers. Each axis is multiplied by the common denominator of its coordinates. That
    preserves sides of lines, and so convexity and visibility. *)

val make : point array -> t
(** The grid of these points, numbered by their places in the array. *)

val orient : t -> int -> int -> int -> int
(** [orient g a b c] is positive if c is left of the way from a to b, 0 on the line through them, else negative. *)

val same : t -> int -> int -> bool
(** [same g a b] is true if both points have the same coordinates. *)

val between : t -> int -> int -> int -> bool
(** [between g a b c] is true if c is on the open segment from a to b. *)

val turns : t -> int -> int -> int -> bool
(** [turns g a b c] is true if the way from a by b to c turns left at b, or goes straight on. *)

val crosses : t -> int * int -> int * int -> bool
(** [crosses g s t] is true if the segments cross at a point inside both. *)

val meet : t -> int * int -> int * int -> bool
(** [meet g s t] is true if the closed segments have a common point. *)

val compare_x : t -> int -> int -> int
(** [compare_x g a b] compares the x coordinates of two points. *)

val compare_y : t -> int -> int -> int
(** [compare_y g a b] compares the y coordinates of two points. *)

val squared : t -> int -> int -> Z.t
(** The squared distance of two points, in the units of the grid, which may differ between the axes. *)

val twice_area : t -> int array -> int
(** The sign of the area of a ring of points: positive if it is counter-clockwise. *)

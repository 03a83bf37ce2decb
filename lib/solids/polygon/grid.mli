(** Points of the plane as integers, for fast exact signs. *)

open Scc_exact

type point = { x : Rat.t; y : Rat.t }

type t
(** Points by their numbers. Each axis is multiplied by the common denominator of its coordinates, which keeps
    sides of lines, and with them convexity and visibility. *)

val make : point array -> t
val count : t -> int

val orient : t -> int -> int -> int -> int
(** [orient g a b c] is positive if c is left of the way from a to b, 0 on the line through them, else negative. *)

val same : t -> int -> int -> bool
(** Two points are at one place. *)

val between : t -> int -> int -> int -> bool
(** [between g a b c]: c is on the open segment from a to b. *)

val turns : t -> int -> int -> int -> bool
(** [turns g a b c]: the way from a by b to c turns left at b, or goes straight on. *)

val crosses : t -> int * int -> int * int -> bool
(** Two segments cross at a point inside of both. *)

val meet : t -> int * int -> int * int -> bool
(** Two closed segments have a point in common. *)

val compare_x : t -> int -> int -> int
val compare_y : t -> int -> int -> int

val squared : t -> int -> int -> Z.t
(** The squared distance of two points, on the grid. *)

val twice_area : t -> int array -> int
(** The sign of the area of a ring: positive when it is counter-clockwise. *)

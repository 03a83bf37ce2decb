(** The check that a face of an indexed face set is a planar, simple, strictly convex polygon (E4, condition 4
    of Definition 4.3). All arithmetic is on integers. *)

open Scc_exact

type problem =
  | Off_plane of int list
  (** the places in the tuple of corners such that the others lie in one plane without that one. If there are
      none, it is the first corner off the plane of the first three that are not collinear. *)
  | Not_left of int  (** the place of a corner at which the tuple does not turn left strictly *)
  | Crossing  (** sides that cross, or a polygon that winds more than once *)

val normal : Ivec.t array -> int array -> Ivec.t
(** [normal points corners] is twice the area vector. For a planar simple polygon it is the unit normal times
    twice the area, towards the side from which the tuple runs counter-clockwise. *)

val check : Ivec.t array -> int array -> (Ivec.t, problem) result
(** The {!normal} of a planar, simple, strictly convex polygon, or its problem. A face off its plane is
    [Off_plane], whatever else is wrong. One that does not turn left somewhere is [Crossing] if its sides cross,
    and [Not_left] otherwise. Crossing sides are searched for up to 64 corners, in quadratic time; larger faces
    are [Not_left] then. The rest is linear. The tuple has at least three entries, in range. *)

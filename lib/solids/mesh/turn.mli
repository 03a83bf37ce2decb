(** Rotations by an axis and an angle, as exact rotations near them. *)

open Scc_exact

val rotation : Vec.t -> Rat.t -> (Mat.t * Rat.t) option
(** [rotation axis angle] is an exact rotation, with rational entries, near that by [angle] radians about [axis].
    The number is a bound of its distance: no point at the distance r from the axis is moved by more than r times
    it. Multiples of a right angle about an axis of rational length are exact, with the bound 0. An angle within
    1/20000 of such a multiple is taken for it. The distance is told, unless both have the same nearest 32-bit
    number (numbers of VRML and X3D have 32 bits), or the angle is the multiple in seven decimals. Small angles
    other than 0 are not 0. [None]: an axis of length 0, with an angle other than 0, or an angle beyond 10{^6}. *)

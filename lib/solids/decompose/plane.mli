(** Oriented planes: the half-space behind one is where n . x <= n . p, for its normal n. *)

open Scc_exact

type near
(** The four numbers in floats, for the filter of {!side}. *)

type t = private { a : Z.t; b : Z.t; c : Z.t; d : Z.t; near : near }
(** a x + b y + c z <= d, without a common divisor *)

val make : Ivec.t -> Homogeneous.t -> t
(** The plane with this normal, which is not zero, through the point. *)

val through : Homogeneous.t -> Homogeneous.t -> Homogeneous.t -> t option
(** The plane through three points that run counter-clockwise as seen from in front; [None] if they are on a
    line. *)

val opposite : t -> t
(** The plane with front and back exchanged. *)

val equal : t -> t -> bool
(** [equal s t] is true if both planes and their orientations are the same. *)

val hash : t -> int
(** A hash that is compatible with {!equal}. *)

val height : t -> Homogeneous.t -> Z.t
(** A number with the sign of the side on which the point is: positive in front, negative behind, 0 on the
    plane. *)

val side : t -> Homogeneous.t -> int
(** The sign of {!height}: 1 in front, -1 behind, 0 on the plane. Floats decide it where their error allows. *)

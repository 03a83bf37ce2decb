(** Boxes that move in straight lines, each until a time of its own, in floats rounded outward: a filter that may
    let through what never meets, and never stops what does. Times are at least 0. *)

open Scc_exact
open Scc_geometry

type t

val create : int -> t
(** [create n]: n boxes, numbered from 0, that are to be {!set} before they are used. *)

val count : t -> int
(** Of its boxes. *)

val set : t -> int -> Float_box.t -> at:Vec.t -> velocity:Vec.t -> unit
(** [set t i b ~at ~velocity]: [b] is given about a point that is at [at] at time 0. *)

val set_until : t -> int -> float -> unit
(** Until when box i moves so: a time > 0, which may be infinite. *)

val until : t -> int -> float

val swept : t -> int -> from:float -> Float_box.t
(** A box that holds box i throughout 0 <= [from] <= t <= {!until}, for finite [from]. *)

val may_meet : t -> int -> int -> from:float -> bool
(** [false] only if the closed boxes have no point in common from [from] on, until the first {!until} of the
    two. *)

val not_before : t -> int -> t -> int -> float
(** [not_before a i b j]: box i of [a] and box j of [b], if both move so for ever, have no point in common from
    time 0 to before this time, which is infinite only if they never have. *)

val not_inside_before : t -> int -> t -> int -> float
(** The same of their interiors: what touches and does not go on into the other is passed over. *)

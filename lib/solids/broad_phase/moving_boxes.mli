(** Boxes that move in straight lines, each until a time of its own, in floats rounded outward. They are a
    filter: pairs that never meet may pass, and pairs that meet always pass. Times are at least 0. *)

open Scc_exact
open Scc_geometry

type t

val create : int -> t
(** [create n] has n boxes, numbered from 0. Each must be {!set} before it is used. *)

val count : t -> int
(** The number of boxes. *)

val set : t -> int -> Float_box.t -> at:Vec.t -> velocity:Vec.t -> unit
(** [set t i b ~at ~velocity] makes box i move with [velocity]. The box [b] is relative to a point that is at
    [at] at time 0. *)

val set_until : t -> int -> float -> unit
(** [set_until t i time] sets the end of the motion of box i: a time > 0, which may be infinite. *)

val until : t -> int -> float
(** [until t i] is the end of the motion of box i, as {!set_until} has set it; initially 0. *)

val swept : t -> int -> from:float -> Float_box.t
(** [swept t i ~from] is a box that contains box i at all times from [from], which is finite, to {!until}. *)

val may_meet : t -> int -> int -> from:float -> bool
(** [may_meet t i j ~from] is [false] only if the closed boxes have no common point from time [from] until the
    first {!until} of the two. *)

val not_before : t -> int -> t -> int -> float
(** [not_before a i b j] is a time before which box i of [a] and box j of [b] have no common point, from time 0
    on. Both move so for ever. It is infinite only if they never have one. *)

val not_inside_before : t -> int -> t -> int -> float
(** [not_inside_before a i b j] is a time before which the interiors of box i of [a] and box j of [b] have no
    common point, from time 0 on. Both move so for ever. Boxes that only touch count as apart. It is infinite
    only if the interiors never meet. *)

(** Boxes that move in straight lines, in floats rounded outward: filters that may let through what never
    meets, and never stop what does. Times are at least 0. *)

open Scc_exact

type t

val make : Float_box.t -> at:Vec.t -> velocity:Vec.t -> t
(** [make b ~at ~velocity]: [b] is given about a point that is at [at] at time 0. *)

val swept : t -> from:float -> until:float -> Float_box.t
(** A box that holds the moving one throughout 0 <= [from] <= t <= [until], for finite [from] and
    [until] > 0. *)

val may_meet : t -> t -> from:float -> until:float -> bool
(** [false] only if the closed boxes have no point in common at any time [from] <= t <= [until]. *)

(** Who is near whom, found by boxes in floats that are rounded outward (the broad phase): no pair that matters is
    missed, and most others are. *)

open Scc_exact
open Scc_semantics

val boxes : unit -> Kinematics.neighbours
(** Up to the limit, few parts in translation are looked at at once in {!Kinematics.neighbours.earliest}; else ever
    longer sweeps of boxes, until something is found. With a memory of the boxes of the last question. *)

val box : margin:Rat.t -> Part.t -> Scc_geometry.Float_box.t
(** Holds the part where it is, and all that is within a margin of it: also wherever it turns, if it does. *)

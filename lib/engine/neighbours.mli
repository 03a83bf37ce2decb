(** Who is near whom, found by boxes in floats that are rounded outward (the broad phase): no pair that matters is
    missed, and most others are. *)

open Scc_exact
open Scc_semantics

val boxes : Kinematics.neighbours
(** Of few parts in translation all are looked at in {!Kinematics.neighbours.earliest}; else ever longer sweeps of
    boxes, until something is found. *)

val box : margin:Rat.t -> Part.t -> Scc_geometry.Float_box.t
(** Holds the part where it is, and all that is within a margin of it: also wherever it turns, if it does. *)

(** The broad phase: a filter of pairs of parts by boxes in floats that are rounded outward. It keeps every pair
    that matters, and drops most others. *)

open Scc_exact
open Scc_semantics

val boxes : unit -> Kinematics.neighbours
(** A new broad phase, with a cache of the boxes of the last query. [Kinematics.neighbours.earliest] sweeps
    boxes over ever longer times until it finds something. For few parts, or if a part has turned, its first
    sweep goes to the limit. *)

val box : margin:Rat.t -> Part.t -> Scc_geometry.Float_box.t
(** A box in the world that contains the part where it is now, and all points within the margin of it. If the part
    turns, the box contains all its orientations about its centre. *)

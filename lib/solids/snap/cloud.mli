(** The solid of which a cloud of rounded points was made. *)

open Scc_exact
open Scc_geometry

val snap : tolerance:Rat.t -> Polyhedron.ifs -> (Snap.snapped, Snap.refusal * Polyhedron.ifs) result
(** [snap ~tolerance hull] takes the exact hull of the points. Its faces that are flat within the distance
    become one face each, and the solid with these faces is {!Snap}ped. No point of the cloud is farther than
    the tolerance in front of a face of the result. A refusal comes with the solid that was to be snapped. *)

(** Boxes around points, as filters. *)

open Scc_exact
open Scc_geometry

val of_points : Vec.t array -> Float_box.t
(** [of_points points] is a box that contains all points, of which there is at least one. *)

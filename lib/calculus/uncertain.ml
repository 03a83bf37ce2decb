(** What of a declared network depends on parameters that have ranges ({!Model.ranges}), as affine forms over
    them. *)

open Scc_polyhedra

type place = Linear.t * Linear.t * Linear.t
(** Coordinates. *)

type t = {
  places : place array;  (** by leaf: of its reference point, in the world, as declared *)
  offsets : place array array;  (** by leaf and part: of a part's reference point from that of its leaf *)
}

(** Reading I-33 for an offset of two solids that is a form over variables: the time at which two features,
    which are closed, first have a common point. They have one at the offsets of a closed polyhedron, which the
    offset enters on a straight line. *)

open Scc_exact
open Scc_polyhedra

val make :
  Polyhedron.t -> offset:Linear.t * Linear.t * Linear.t -> velocity:Vec.t -> limit:Linear.t option ->
  Polyhedron.t ->
  (Polyhedron.t * Linear.t) list * Polyhedron.t list
(** [make offsets ~offset ~velocity ~limit within], where [offsets] is the closed set of offsets at which the
    features meet. The offset now and its velocity are as for {!Contact_cells.make}. The first list has the
    regions where they first meet, now or later and not after the limit, with the time. The second list has the
    regions where they do not. All pieces are disjoint, none is empty, and their union is [within]. *)

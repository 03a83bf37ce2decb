(** Reading I-33 where the offset of two solids is not known but for what it depends on: when two features of them,
    which are closed, come to have a point in common as the solids go on. They do at the offsets of a closed
    polyhedron, into which the offset goes on a straight line. *)

open Scc_exact
open Scc_polyhedra

val make :
  Polyhedron.t -> offset:Linear.t * Linear.t * Linear.t -> velocity:Vec.t -> limit:Linear.t option ->
  Polyhedron.t ->
  (Polyhedron.t * Linear.t) list * Polyhedron.t list
(** [make offsets ~offset ~velocity ~limit within]: of the offsets at which they meet, which are closed; the
    offset now and its velocity as for {!Contact_cells.make}. Where they first meet, now or later and not later
    than the limit, with the time at which they do; and where they do not: disjoint pieces, none empty, that make
    up [within]. *)

(** Which features of two solids touch (reading I-3), where the offset of the solids is not known: the relative
    interiors of two features have a point in common iff the offset is in the relative interior of their Minkowski
    difference, which is a polyhedron. *)

open Scc_geometry
open Scc_polyhedra

type memory

val create : unit -> memory
(** What it has made, it remembers by the solids' {!Solid.id}. *)

type side = { solid : Solid.t; feature : Feature.t }

val offsets : memory -> side -> side -> Polyhedron.t
(** The offsets, of the second solid from the first, at which the two features touch: a polyhedron of dimension 3.
*)

val dimension : memory -> side -> side -> int
(** Of the intersection of the two where they touch: it is the same for all offsets. *)

(** The features of two solids that touch (reading I-3), as sets of offsets of the solids. The relative
    interiors of two features have a common point iff the offset is in the relative interior of their Minkowski
    difference. That is a polyhedron. *)

open Scc_geometry
open Scc_polyhedra

type memory

val create : unit -> memory
(** A new, empty cache. Its keys are the ids of solids ({!Scc_geometry.Solid.id}) and features. *)

type side = { solid : Solid.t; feature : Feature.t }

val touching : memory -> side -> side -> Polyhedron.t
(** The offsets, of the second solid from the first, at which the two features touch: a polyhedron of dimension
    3. *)

val dimension : memory -> side -> side -> int
(** The dimension of the intersection of two features where they touch. It is the same for all offsets. *)

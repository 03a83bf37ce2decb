(** The check that faces bound a solid, which need not be convex. *)

open Scc_exact
open Scc_geometry

type fault =
  | Structure of Polyhedron_fault.t list
  (** not empty. Faults are: no faces; vertices that are out of range, unused or at one position; edges that
      are not in two faces of opposite directions. Others are: faces that are not flat or not simple; a surface
      that is turned inward. *)
  | Cut of int * int * Vec.t
  (** two faces that have this point in common, which is at no edge or corner that they share *)

val faults : Polyhedron.ifs -> fault option
(** The first fault that is found; [None] for sound faces. Faces are sound if each edge is in two of them, once
    in each direction, and they bound a positive volume. Sound faces are simple polygons that meet at common
    edges and corners only. The check is exact. Pairs of faces are compared only if their boxes meet. *)

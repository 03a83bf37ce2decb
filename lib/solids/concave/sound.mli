(** Whether faces bound a solid, which need not be convex. *)

open Scc_exact
open Scc_geometry

type fault =
  | Structure of Polyhedron_fault.t list
  (** not empty: no faces, corners that are out of range or doubled, edges that are not in two faces of opposite
      directions, faces that are not flat or not simple, a surface that is turned inward *)
  | Cut of int * int * Vec.t
  (** two faces that have this point in common, which is at no edge or corner that they share *)

val faults : Polyhedron.ifs -> fault option
(** [None]: every edge is in two faces, one for each direction, the faces are simple polygons, meet at common
    edges and corners alone, and bound a positive volume. Exact. Faces whose boxes are apart are not looked at
    in pairs. *)

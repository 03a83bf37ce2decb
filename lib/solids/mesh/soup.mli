(** Triangles from files that do not identify equal corners as one vertex. *)

open Scc_exact
open Scc_geometry

type t

val create : unit -> t
(** A new set without triangles. *)

val number : t -> Vec.t -> int
(** [number soup x] is the number of the vertex at the point [x]. Equal points have one number; numbers are in
    the order of first calls, from 0. *)

val add : t -> int -> int -> int -> unit
(** [add soup a b c] adds the triangle of three vertices. If two of them are equal, the triangle is dropped. *)

val solid : t -> Polyhedron.ifs
(** The set of faces, made maximal by {!Merge_coplanar}. Without any triangle it is a cloud of all the
    points. *)

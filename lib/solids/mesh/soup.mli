(** Triangles as they come in files that do not tell which corners are one vertex. *)

open Scc_exact
open Scc_geometry

type t

val create : unit -> t

val number : t -> Vec.t -> int
(** Of the vertex at this very point: the same for equal points, in the order in which they are first met. *)

val add : t -> int -> int -> int -> unit
(** The triangle of three such vertices; one with two equal corners is no triangle, and is left out. *)

val solid : t -> Polyhedron.ifs
(** With maximal faces ({!Merge_coplanar}); without any triangle it is a cloud of all the points. *)

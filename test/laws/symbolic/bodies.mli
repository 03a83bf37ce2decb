(** The shapes of random scenes: small, with corners at integers. *)

open Scc_exact
open Scc_geometry

val solids : Solid.t array
(** The cube of side 2; half of it; an octahedron; a tetrahedron. All about the origin. *)

val shapes : (int * Vec.t) list array
(** Those, and compounds of two parts that touch: parts as (solid, offset). *)

(** The geometry of contact a second time, as plainly as can be: rational points, every separating axis, no
    obstacle and nothing remembered. It shares only vectors and rationals with the library, and is slow. *)

open Scc_exact

(** A convex polyhedron where it stands: corners, and faces as cycles of their indices,
    counter-clockwise seen from outside. *)
type solid = { points : Vec.t array; faces : int list list }

val move : Mat.t -> Vec.t -> solid -> solid
(** Turned, then displaced. *)

type relation = Apart | Touching | Interpenetrating

val relation : solid -> solid -> relation

type cast = Never | Inside | At of Rat.t

val first_time_of_contact : solid -> solid -> Vec.t -> cast
(** The second solid moves with the velocity. *)

val meeting : solid -> solid -> Vec.t -> (Rat.t option * Rat.t option) option
(** The closed interval of all real times at which the closed solids meet. *)

val facets : solid -> solid -> Vec.t list
(** Directions of all separating axes whose plane carries a facet of the Minkowski difference; may repeat. *)

val edges : solid -> (int * int) list
(** The smaller index first, each once, in lexicographic order. *)

val touching : solid -> solid -> (int list * int list * int) list
(** Of two solids that touch: all pairs of features (as the sorted indices of their corners) whose relative
    interiors intersect, with the dimension of the intersection. *)

val relative_interiors_meet : Vec.t list -> Vec.t list -> bool
(** Of the convex hulls of two finite sets of points. *)

val hull : Vec.t list -> solid
(** The convex hull of points that do not lie in one plane. *)

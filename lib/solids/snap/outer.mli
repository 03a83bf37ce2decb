(** Convex solids with few faces around others. *)

open Scc_exact
open Scc_geometry

type t = {
  solid : Polyhedron.ifs;  (** faces are [f0], …, vertices [v0], … *)
  faces : int;  (** of the hull *)
  beyond : Rat.t;
  (** A bound on the distance of all points of the solid from the hull. It is the greatest distance if that is
      rational. Otherwise it is greater by less than two in forty bits. *)
}

val of_hull : faces:int -> Polyhedron.ifs -> (t, int) result
(** [of_hull ~faces hull] is a convex closed polyhedron with at most [faces] faces, at least four, that
    contains the hull ([Hull_of.hull]). If the hull has no more faces, it is the hull itself, with its names.
    Each face has the direction of a face of the hull, rounded to about fifteen bits so that corners have short
    numbers. Each face touches the hull. The choice of faces is a guess ({!Thinned}); the rest is exact. [Error
    n]: with fewer than n faces of such directions no bounded solid was found. *)

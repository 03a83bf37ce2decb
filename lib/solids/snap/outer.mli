(** Convex solids with few faces around others. *)

open Scc_exact
open Scc_geometry

type t = {
  solid : Polyhedron.ifs;  (** faces are [f0], …, vertices [v0], … *)
  faces : int;  (** of the hull *)
  beyond : Rat.t;
  (** no point of the solid is farther from the hull: the greatest distance if that is rational, and otherwise more
      than it by less than two in forty bits *)
}

val of_hull : faces:int -> Polyhedron.ifs -> (t, int) result
(** A convex closed polyhedron of at most so many faces, at least four, that contains the hull ({!Hull_of.hull}):
    the hull itself, if it has no more, with its names. Each face has the direction of one of the hull, rounded to
    some fifteen bits so that corners have short numbers, and touches the hull. Which ones is a guess ({!Thinned}),
    all else is exact. [Error n]: with fewer than n faces of such directions no bounded solid was found. *)

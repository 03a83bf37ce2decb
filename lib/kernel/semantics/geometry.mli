(** The queries of the rules to geometry, as a record of functions over which the semantics is parametric. Bodies
    are placed parts, A and B. Two bodies in translation have a relative velocity w, that of B less that of A.
    Times count from now.

    {!exact} is the geometry of the rule book's first chapter and of Cast and Near. Tests put a geometry by brute
    force in its place. *)

open Scc_exact
open Scc_geometry
open Scc_rigid

(** Two bodies on straight paths: when they come into contact, if they keep to their velocities for ever, and
    whether the interiors of the spaces meet that they sweep in a span. *)
type paths = { contact : Obstacle.cast; sweeps_meet : bool Lazy.t }

type t = {
  relation : Placed.t -> Placed.t -> Obstacle.relation;  (** rule Contact *)
  approaching : Placed.t -> Placed.t -> Vec.t -> bool;  (** rule Approach, for two bodies that touch *)
  first_time_of_contact : Placed.t -> Placed.t -> Vec.t -> Obstacle.cast;  (** rule Ftoc, in translation *)
  meeting : Placed.t -> Placed.t -> Vec.t -> (Rat.t option * Rat.t option) option;
  (** the closed interval of times, also past ones, at which two bodies in translation meet, if they ever do; an
      end is [None] if it is infinite *)
  touching : Placed.t -> Placed.t -> Contact.pair list;  (** rule Touching: the features that touch, sorted *)
  directions : (Placed.t * Placed.t) list -> Vec.t -> Vec.t list;
  (** rule Response: the directions, from the first body to the second, that span the cone of a collision in
      translation; given all touching pairs of parts of the two bodies, and the relative velocity before it *)
  paths : Placed.t -> Placed.t -> span:Rat.t -> Vec.t -> Vec.t -> paths;
  (** rule Blocked: how two bodies in translation are to each other that have these two velocities for the span *)
  first_meeting : Vec.t list -> Vec.t list -> Vec.t -> Rat.t option;
  (** the least time t >= 0 at which two features meet, each given by its corners; the second one moves with the
      velocity *)
  first_penetration : Motion.t -> Motion.t -> span:Rat.t -> grid:int -> phase:Rat.t -> Cast.outcome;
  (** rule Cast *)
  near : resolution:Rat.t -> Placed.t -> Placed.t -> Near_contact.t option;  (** rule Near *)
}

val exact : obstacle:(Solid.t -> Solid.t -> Obstacle.t) -> t
(** [exact ~obstacle] is the exact geometry. [obstacle] is [Obstacle.make] or a cache of it, and is applied to
    solids as declared. For parts in translation that have turned, each query builds the turned solids and their
    obstacle. *)

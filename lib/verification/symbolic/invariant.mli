(** Sets of states that no run leaves: the abstract domain of rule Invariants. A set is finitely many locations,
    each a kind of states (processes, bonds, velocities, behaviours as they were when they were set) with a
    polyhedron over all numbers of such a state. It stands for the well-formed states whose kind is that of a
    location and whose numbers are in its polyhedron: bodies that interpenetrate are in no run (rule WellFormed),
    and a convex set cannot leave them out. *)

open Scc_polyhedra
open Scc_calculus
open Scc_property

type location = {
  skeleton : State.t;  (** as that of a {!Zone.t} *)
  arrived : int list;  (** the numbers of the events that have just led here *)
  set : Polyhedron.t;  (** over the {!Zone.coordinates}, without time, in their order *)
}

type t = {
  events : Property.event array;
  locations : location list;  (** those of one kind, if there are several, together *)
}

val dimension : Model.t -> int
(** How many coordinates. *)

val name : Model.t -> int -> string
(** Of a coordinate: the parameter, or ["age(p)"], ["clock(p)"], ["x(p)"], ["y(p)"], ["z(p)"], where time since a
    behaviour was set, or a split clock, and the place of the reference point of a body are meant. *)

val zone : Model.t -> location -> Zone.t
(** The same with a variable for each coordinate; not canonical. *)

val set_of : Zone.t -> Polyhedron.t
(** What a canonical zone without time says of all coordinates. *)

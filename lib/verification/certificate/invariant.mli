(** Sets of states that no run leaves: the abstract domain of rule Invariants. A set consists of finitely many
    locations. A location is a kind of states with a polyhedron over all numbers of such a state. A kind
    consists of processes, bonds, velocities, and behaviours as they were when they were set. The set contains
    the well-formed states whose kind is that of a location and whose numbers are in its polyhedron. In no run
    do bodies interpenetrate (rule WellFormed), but a convex set cannot exclude such states. *)

open Scc_polyhedra
open Scc_calculus
open Scc_property
open Scc_state_sets

type location = {
  skeleton : State.t;  (** as that of a {!Scc_state_sets.Zone.t} *)
  arrived : int list;  (** the numbers of the events that have just led here *)
  set : Polyhedron.t;  (** over the {!Scc_state_sets.Zone.coordinates}, without time, in their order *)
}

type t = {
  events : Property.event array;
  locations : location list;  (** locations of one kind are adjacent *)
}

(** The claim that no state of any run satisfies the predicate [never], for these values of the parameters. *)
type claim = { never : Property.prop; values : Union.t }

val dimension : Model.t -> int
(** The number of coordinates: one for each parameter with a range, five for each leaf. *)

val name : Model.t -> int -> string
(** The name of a coordinate: a parameter, or ["age(p)"], ["clock(p)"], ["x(p)"], ["y(p)"] or ["z(p)"] of a
    leaf. An age is the time since a behaviour was set, a clock is a split clock. The others are the place of
    the reference point. *)

val zone : Model.t -> location -> Zone.t
(** The location as a zone with a variable for each coordinate. The zone is not canonical. *)

(** Sets of states of a network that differ in numbers alone: the same processes, bonds, velocities and
    behaviours, while places, what is left of delays, split clocks and time are affine in finitely many variables,
    which take all values of a convex polyhedron. This is exact where bodies go in straight lines, as all
    velocities are constants of what has happened.

    The {b coordinates} of a zone are all these numbers: the parameters of the model
    ({!Scc_calculus.Model.ranges}), time, ages, clocks, places. In a canonical zone ({!canonical}) the variables
    are coordinates themselves, the first ones on which all others depend, so that one set has one such form but
    for how its polyhedron is described. *)

open Scc_exact
open Scc_polyhedra
open Scc_calculus

type t = {
  skeleton : State.t;
  (** what is the same in all states: the places of leaves are zero there, the behaviours are as they were when
      they were last set, and split clocks are [Some 0] *)
  halted : bool;
  (** time has stopped here for a weak split, which is all that may happen: what else is due comes later *)
  arrived : int list;  (** the numbers of the events that have just led here, increasing *)
  set : Polyhedron.t;  (** of the values of the variables; not empty *)
  parameters : Linear.t array;
  time : Linear.t option;  (** model time since the start, where somebody asks for it *)
  ages : Linear.t array;
  (** by leaf: for how long the behaviour has aged since it was set; 0 where nothing of it does *)
  clocks : Linear.t array;  (** by leaf: the split clock of the process whose first leaf it is; 0 elsewhere *)
  places : Place.t array;  (** by leaf *)
  basis : int array;  (** of a canonical zone: for each variable, which coordinate it is *)
}

val dimension : t -> int
(** How many variables. *)

val coordinates : t -> Linear.t array

val with_variables : t -> dimension:int -> Linear.t array -> Polyhedron.t -> t
(** [with_variables z ~dimension forms set]: all numbers of the zone by other variables, of which the old ones are
    these forms; they take the values of [set]. *)

val centred : t -> t
(** Each state moved as a whole, such that its first leaf comes to the origin (rule Translation). *)

val renamed : t -> int array -> t
(** With other names for leaves: for each the one that it gets (rule Symmetry). *)

val canonical : t -> t * Linear.t array
(** The same set of states by its own coordinates; and the new variables as forms over the old ones. *)

val of_coordinates : t -> set:Polyhedron.t -> basis:int array -> Linear.t array -> t
(** [of_coordinates z ~set ~basis forms]: a zone like z with these {!coordinates}. *)

val same_forms : t -> t -> bool
(** Whether all coordinates are the same forms. *)

val at : t -> Rat.t array -> State.t
(** The state that the variables have these values in; with behaviours as they were when they were set. *)

val same_kind : t -> t -> bool
(** The same but for numbers. *)

val hash_kind : t -> int

val merged : t -> t -> t option
(** The states of two canonical zones of one kind together, where their numbers are the same forms and the union of
    their sets is convex. *)

val sample : t -> Rat.t array
(** The {!coordinates} of one of its states. *)

val has : t -> Rat.t array -> bool
(** Of a canonical zone, and the coordinates of some state of one of its kind that is {!included} in it: true. A
    quick way to see of most others that they are not. *)

val included : t -> t -> Linear.t array option
(** [included a b], of canonical zones of one kind: if each state of a is one of b, the variables of b as forms
    over those of a. *)

(** Sets of states of a network that differ in numbers alone. Processes, bonds, velocities and behaviours are
    the same in all states. Places, ages, split clocks and time are affine in finitely many variables, which
    take all values of a convex polyhedron. This is exact where bodies move in straight lines, as past events
    determine all velocities.

    The {b coordinates} of a zone are all these numbers: the parameters of the model
    ({!Scc_calculus.Model.ranges}), time, ages, clocks, places. In a canonical zone ({!canonical}) the
    variables are coordinates themselves: the first ones on which all others depend. So a set has one such
    form, up to the description of its polyhedron. *)

open Scc_exact
open Scc_polyhedra
open Scc_offsets
open Scc_calculus

type t = {
  skeleton : State.t;
  (** The part that is the same in all states. Places of leaves are zero there, behaviours are as they were
      when they were last set, and split clocks are [Some 0]. *)
  halted : bool;
  (** time has stopped here for a weak split, the only possible event; other events come later *)
  arrived : int list;  (** the numbers of the events that have just led here, increasing *)
  set : Polyhedron.t;  (** of the values of the variables; not empty *)
  parameters : Linear.t array;
  time : Linear.t option;  (** model time since the start, if it is a coordinate *)
  ages : Linear.t array;
  (** by leaf: the time that the behaviour has aged since it was set; 0 if it does not age *)
  clocks : Linear.t array;  (** by leaf: the split clock of the process whose first leaf it is; 0 elsewhere *)
  places : Place.t array;  (** by leaf *)
  basis : int array;  (** of a canonical zone: for each variable, the number of its coordinate *)
}

val dimension : t -> int
(** The number of variables. *)

val coordinates : t -> Linear.t array
(** The coordinates in order: parameters, time if it is kept, ages, clocks, then x, y and z of each place. *)

val place : t -> int -> Model.part -> Place.t
(** [place z leaf part] is the place of the reference point of a part of the leaf. *)

val with_variables : t -> dimension:int -> Linear.t array -> Polyhedron.t -> t
(** [with_variables z ~dimension forms set] is [z] over other variables, which take the values of [set]. The
    old variables are these forms over the new ones. *)

val centred : t -> t
(** The zone with each state moved as a whole such that its first leaf is at the origin (rule Translation). *)

val renamed : t -> int array -> t
(** [renamed z image] is [z] with the name [image.(i)] for leaf [i] (rule Symmetry). *)

val canonical : t -> t * Linear.t array
(** [canonical z] is the set of states of [z] over its own coordinates, and the new variables as forms over the
    old ones. *)

val of_coordinates : t -> set:Polyhedron.t -> basis:int array -> Linear.t array -> t
(** [of_coordinates z ~set ~basis forms] is a zone like [z] with the {!coordinates} [forms]. *)

val same_forms : t -> t -> bool
(** [same_forms a b] is true if all coordinates are the same forms over as many variables, with the same
    basis. *)

val at : t -> Rat.t array -> State.t
(** [at z point] is the state for these values of the variables. Its behaviours are as they were when they were
    last set. *)

val same_kind : t -> t -> bool
(** [same_kind a b] is true if skeletons, [halted] and [arrived] are the same: the zones differ only in
    numbers. *)

val hash_kind : t -> int
(** A hash that is compatible with {!same_kind}. *)

val merged : t -> t -> t option
(** The states of two canonical zones of one kind together. [None] unless their coordinates are the same forms
    and the union of their sets is convex. *)

val sample : t -> Rat.t array
(** The {!coordinates} of one of its states. *)

val has : t -> Rat.t array -> bool
(** [has z coordinates] is true if the state with these coordinates is in the canonical zone [z]. It is a quick
    test against inclusion: if the coordinates are those of a state of a zone {!included} in [z], it is true.
    The state has to be of the kind of [z]. *)

val included : t -> t -> Linear.t array option
(** [included a b], for canonical zones of one kind, is [Some forms] if each state of [a] is a state of [b].
    The forms are the variables of [b] over those of [a]. *)

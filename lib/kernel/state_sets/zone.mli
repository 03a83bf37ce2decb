(** Sets of states of a network that differ in numbers alone. Processes, bonds, velocities and behaviours are
    the same in all states. Places, ages, split clocks and time are affine in finitely many variables, which
    take all values of a convex polyhedron. This is exact where bodies move in straight lines, as past events
    determine all velocities.

    The {b coordinates} of a zone are all these numbers: the parameters of the model
    ({!Scc_calculus.Model.ranges}), time, ages, clocks, places. In a canonical zone
    ([Zone_form.canonical] of the search) the variables are coordinates themselves: the first ones on which all
    others depend. So a set has one such form, up to the description of its polyhedron. *)

open Scc_exact
open Scc_polyhedra
open Scc_offsets
open Scc_calculus

type t = {
  skeleton : State.t;
  (** The part that is the same in all states. Places of leaves are zero there, behaviours are as they were
      when they were last set, split clocks are [Some 0], and times of the movement step and of lots are 0. *)
  halted : bool;
  (** time has stopped here for a weak split, the only possible event; other events come later *)
  arrived : int list;  (** the numbers of the events that have just led here, increasing *)
  set : Polyhedron.t;  (** of the values of the variables; not empty *)
  parameters : Linear.t array;
  time : Linear.t option;  (** model time since the start, if it is a coordinate *)
  step : Linear.t option;  (** the time left in the movement step of the network, if it has one (rule Steer) *)
  grid : Linear.t option;  (** the time since the last split instant of the network, if it has lots (rule Lot) *)
  ages : Linear.t array;
  (** by leaf: the time that the behaviour has aged since it was set; 0 if it does not age *)
  clocks : Linear.t array;  (** by leaf: the split clock of the process whose first leaf it is; 0 elsewhere *)
  places : Place.t array;  (** by leaf *)
  basis : int array;  (** of a canonical zone: for each variable, the number of its coordinate *)
}

val skeleton : State.t -> State.t
(** [skeleton s] is [s] as the skeleton of a zone: with all of its numbers zero that are coordinates. *)

val declared : Model.t -> Uncertain.t -> State.t -> keeps_time:bool -> t
(** [declared m u s ~keeps_time] are the declared states for all values of the parameters, where [s] is that for
    some values. The variables are the parameters. With [keeps_time], time is a coordinate, and is 0. *)

val dimension : t -> int
(** The number of variables. *)

val coordinates : t -> Linear.t array
(** The coordinates in order: parameters, those of time, step and grid that there are, ages, clocks, then x, y
    and z of each place. *)

val place : t -> int -> Model.part -> Place.t
(** [place z leaf part] is the place of the reference point of a part of the leaf. *)

val with_variables : t -> dimension:int -> Linear.t array -> Polyhedron.t -> t
(** [with_variables z ~dimension forms set] is [z] over other variables, which take the values of [set]. The
    old variables are these forms over the new ones. *)

val earliest : t -> Rat.t option
(** The greatest lower bound of the model time of its states; [None] if time is no coordinate. *)

val values : t -> Rat.t array -> Rat.t array
(** [values z point] are the values of the parameters for these values of the variables. *)

val at : t -> Rat.t array -> State.t
(** [at z point] is the state for these values of the variables. Its behaviours are as they were when they were
    last set. *)

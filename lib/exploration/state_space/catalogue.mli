(** Numbers for the components of states (collapse compression): a process is the triple of its form (its leaves
    relative to the first of them, with their behaviours, its bonds and its split clock), its place and its
    velocity, each stored once; a state is a tuple of numbers of processes. Exact: equal numbers mean equal
    things, and only they. *)

open Scc_exact
open Scc_calculus
open Scc_semantics

type t

val create : marked:bool -> time_seen:Scc_property.Time_seen.t -> memory:int -> Model.t -> t
(** Times of states that are the same to what sees so much of time get one number (rule AbsoluteTime). [memory], a
    power of two, bounds how many processes are kept as they were last given out. *)

val model : t -> Model.t
val time_seen : t -> Scc_property.Time_seen.t

val width : t -> int
(** Of the tuples: a slot for each leaf, which holds the process whose first leaf it is, or {!nobody}; and slots
    for the movement step and for the time, when the model keeps them. *)

val nobody : int

val time_slot : t -> int
(** Where the time stands, if states have it. *)

val mark_slot : t -> int
(** Where the mark stands; {!encode} leaves it 0, and {!decode} does not look at it. *)

val encode : t -> State.t -> int array
val decode : t -> int array -> State.t

val time : t -> int array -> Rat.t option
(** Absolute, if states have it. *)

val step : t -> int array -> State.step option
(** The movement step of the network, if states have it. *)

val put_rest : t -> int array -> step:State.step option -> time:Rat.t option -> unit
(** Writes what a state has besides its processes. *)

val same_rest : t -> int array -> int array -> bool
(** Two states have all but their processes in common, the mark included. *)

val time_after : t -> int array -> Rat.t -> int option
(** What is in the slot of time when so much has passed, if states have time. *)

(** {1 Slots} *)

(** What the numbers in a slot stand for. *)
type slot = Process | Step | Time | Mark

val slot : t -> int -> slot

val step_of_number : t -> int -> State.step
val step_number : t -> State.step -> int
val rational : t -> int -> Rat.t
(** Of a number in the slot of time. *)

val rational_number : t -> Rat.t -> int
(** Of such a time, as it is seen. *)

(** {1 Components} *)

(** Things numbered as they are first seen. *)
module Interned (Thing : Hashtbl.HashedType) : sig
  type t

  val create : unit -> t
  val size : t -> int
  val get : t -> int -> Thing.t
  val intern : t -> Thing.t -> int
end

val process : t -> State.process -> int
(** The number of a process; never {!nobody}. *)

(** What stands behind the number of a process. *)
type body = private {
  number : int;
  form : int;
  place : int;
  velocity : int;
  process : State.process;
}

val no_body : body
(** Stands for no process: its number is {!nobody}. *)

val body : t -> int -> body

val remembered : t -> 'value -> (State.process -> 'value) -> int -> 'value
(** A function of processes as one of their numbers, that remembers its last values. Any value is needed to begin
    with. *)

val displaced : t -> Rat.t -> body -> int
(** Where its velocity takes it in a time, with nothing else changed. *)

val shifted : t -> Vec.t -> int -> int
(** The same process elsewhere, by this vector. *)

val form : t -> int -> State.process
(** The process of this form whose first leaf is at the origin, at rest. *)

val first_leaf : State.process -> int

val label : t -> Transition.label -> int

val time_label : t -> Rat.t -> int
(** Of so much time that passes. *)

val hash_label : Transition.label -> int
val label_of : t -> int -> Transition.label

val labels : t -> Transition.label list
(** That have come up. *)

val has_events : t -> bool
(** Whether a label has come up that is no passing of time. *)

val duration : t -> int -> Rat.t
(** Of a label. *)

val bodies : t -> int
(** How many processes have been seen. *)

val forms : t -> int

val greatest_bits : t -> int
(** No number that came up is longer; with the parts of a process relative to its first leaf. *)

val longest : t -> (string * int) list
(** How far numbers have grown: by what they are numbers of, the most bits that one of them takes, numerator and
    denominator together: [positions], [velocities] and, for rigid models, [spins] and [orientations] (a component
    of a quaternion), with [free_body] also [angular_momenta]. Looks at everything. *)

val resting : t -> int -> bool
(** Whether the velocity of this number is zero. *)

(** Numbers for the components of states (collapse compression). A process is the triple of its form, its place
    and its velocity, and each of these is stored once. The form is the leaves relative to the first of them,
    with their behaviours, bonds and split clock. A state is a tuple of numbers of processes. The numbering is
    exact: numbers are equal iff what they stand for is equal. *)

open Scc_exact
open Scc_calculus
open Scc_semantics

type t

val create : marked:bool -> time_seen:Scc_property.Time_seen.t -> memory:int -> Model.t -> t
(** [create ~marked ~time_seen ~memory m] is an empty catalogue. With [marked], tuples have a slot for a mark.
    Times that [time_seen] does not tell apart get one number (rule AbsoluteTime). [memory], a power of two,
    bounds the number of processes in the cache of {!val-body}. *)

val model : t -> Model.t
(** The model of the states. *)

val time_seen : t -> Scc_property.Time_seen.t
(** The times that the catalogue tells apart. *)

val width : t -> int
(** The width of the tuples. Each leaf has a slot for the process whose first leaf it is, or {!nobody}. Behind
    these are slots for the movement step, the time and the mark, if states have them. *)

val nobody : int
(** The number 0, in the slots of leaves that are no first leaf of a process. *)

val time_slot : t -> int
(** The index of the slot of the time, if states have it. *)

val mark_slot : t -> int
(** The index of the slot of the mark. {!encode} sets it to 0, and {!decode} ignores it. *)

val encode : t -> State.t -> int array
(** The tuple of a state. New components get numbers. *)

val decode : t -> int array -> State.t
(** The state of a tuple. *)

val time : t -> int array -> Rat.t option
(** The absolute time of a tuple, as its number represents it; [None] if states have no time. *)

val step : t -> int array -> State.step option
(** The movement step of the network in a tuple; [None] if states have none. *)

val put_rest : t -> int array -> step:State.step option -> time:Rat.t option -> unit
(** [put_rest t tuple ~step ~time] writes the slots of the movement step and of the time into [tuple]. *)

val same_rest : t -> int array -> int array -> bool
(** [same_rest t a b] is true if [a] and [b] are equal in all slots that are not of processes, including the
    mark. *)

val time_after : t -> int array -> Rat.t -> int option
(** [time_after t tuple d] is the number in the slot of the time after a further time [d]; [None] if states have
    no time. *)

(** {1 Slots} *)

(** The kind of things that the numbers in a slot stand for. *)
type slot = Process | Step | Time | Mark

val slot : t -> int -> slot
(** The kind of the slot with an index. *)

val step_of_number : t -> int -> State.step
(** The movement step that a number in its slot stands for. *)

val step_number : t -> State.step -> int
(** The number of a movement step. *)

val rational : t -> int -> Rat.t
(** The time that a number in its slot stands for. *)

val rational_number : t -> Rat.t -> int
(** The number of a time. Times that are not told apart have one number. *)

(** {1 Components} *)

val process : t -> State.process -> int
(** The number of a process; never {!nobody}. *)

(** The components of a process with a number. *)
type body = private {
  number : int;
  form : int;
  place : int;
  velocity : int;
  process : State.process;
}

val no_body : body
(** The body that stands for no process: its number is {!nobody}. *)

val body : t -> int -> body
(** The body of the process with a number, which must not be {!nobody}. *)

val remembered : t -> 'value -> (State.process -> 'value) -> int -> 'value
(** [remembered t any f] is [f] as a function of the numbers of processes, with a cache of 4096 values. [any] is
    some value to fill the cache with. *)

val displaced : t -> Rat.t -> body -> int
(** [displaced t d b] is the number of the process of [b], moved for a time [d] by its velocity, and otherwise
    the same. *)

val shifted : t -> Vec.t -> int -> int
(** [shifted t v n] is the number of the process with number [n], translated by [v]. *)

val form : t -> int -> State.process
(** The process of the form with a number, with its first leaf at the origin, and at rest. *)

val first_leaf : State.process -> int
(** The index of the first leaf of a process, which is its slot. *)

val label : t -> Transition.label -> int
(** The number of a label; a new label gets the next number. *)

val time_label : t -> Rat.t -> int
(** The number of the label of a passing of time by this much. *)

val hash_label : Transition.label -> int
(** A hash that agrees with {!Scc_semantics.Transition.equal_label}. *)

(** The draws and lots of one instant as one transition (rule JoinedDraws): the chance of all of them together,
    and the number of transitions that it stands for. *)
type joint = { chance : Rat.t; transitions : int }

val tied : t -> Transition.label -> Rat.t -> int
(** [tied c l chance] is the number of the label [l] of an urgent transition to which chance gives the
    probability [chance] (rule Ties). *)

val label_of_transition : t -> Transition.t -> int
(** The number of {!tied} for an urgent transition with a probability, and of {!label} for all others. *)

val joint : t -> joint -> int
(** The number of a label for joined draws; a new label gets the next number. *)

val label_of : t -> int -> Transition.label
(** The label with a number. A number of {!joint} is a bug. *)

val single : t -> int -> Transition.label option
(** The label with a number; [None] for a number of {!joint}. *)

val chance : t -> int -> Rat.t option
(** The chance of the label with a number, if chance decides: it is a draw, a lot, or a number of {!tied} or
    {!joint}. *)


val transitions : t -> int -> int
(** How many transitions of a run the label with a number stands for: 1, except for a number of {!joint}. *)

val labels : t -> Transition.label list
(** All labels with a number but those of {!joint}, each once, in the order of their numbers. *)

val has_events : t -> bool
(** [has_events t] is true if a label has a number that is no passing of time. *)

(** {1 Several processes} *)

(** A label as it has a number. *)
type label = One of Transition.label | Tied of Transition.label * Rat.t | Joint of joint

val any_label : t -> int -> label
(** The label with a number. *)

(** The things as texts, which are the same in all processes, and back. *)
type texts = {
  process : State.process -> string;
  of_process : string -> State.process;
  label : label -> string;
  of_label : string -> label;
  step : State.step -> string;
  of_step : string -> State.step;
  time : Rat.t -> string;
  of_time : string -> Rat.t;
}

val share : t -> Scc_graph_search.Common.t -> texts -> bool
(** [share t table texts] makes the numbers of things that come up from now on the same in all processes that are
    forked afterwards. It takes the kinds 0 to 3 of the table. It is false, and nothing has changed, if the
    system gives no memory. *)

val numbers_so_far : t -> int
(** [numbers_so_far t] is more than any number that has been given. *)

val duration : t -> int -> Rat.t
(** The time that passes in a transition with the label of this number; 0 for an event. *)

val bodies : t -> int
(** The number of different processes so far. *)

val greatest_bits : t -> int
(** The greatest length in bits of a number in any component so far, numerator and denominator together. In
    forms, places are relative to the first leaf. It takes constant time. *)

val longest : t -> (string * int) list
(** The greatest length in bits of each kind of numbers so far, numerator and denominator together. The kinds are
    [positions] and [velocities]. Rigid models have also [spins] and [orientations] (components of quaternions),
    and with [free_body] [angular_momenta]. It visits all components. *)

val resting : t -> int -> bool
(** [resting t v] is true if the velocity with number [v] is zero. *)

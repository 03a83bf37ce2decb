(** The meaning of each atom, defined once: which part of a state it depends on, and as which function. A state,
    a tuple of numbers and a stretch of time are views ({!Terms.View}) that apply this function, each to its own
    data. *)

open Scc_ctl
open Scc_calculus
open Scc_semantics
open Scc_motion
open Scc_property

(** Over sets of states, functions of processes are taken to be affine in places. *)
type quantity =
  | Of_process of int * (Path.t -> Path.curve)
  (** a function of the process that has the leaf; for an absorbed leaf it is undefined ({!of_the_gone}) *)
  | Counted of int * (State.process -> int)
  (** a function of the process that has the leaf, 0 for an absorbed leaf; it stays the same while time passes *)
  | Of_two of int * int * (Path.t -> Path.t -> Path.curve)
  (** a function of the processes that have the leaves, which may be one process *)
  | Sum of (Path.t -> Path.curve)  (** a sum over all processes *)
  | Number of Property.quantity * (State.process -> int)
  (** this atom, as a sum over all processes; the sum and each part stay the same while time passes *)
  | Time  (** absolute time *)
  | Parameter of int  (** the parameter with this index among those with ranges; one run has its value instead *)

type fact =
  | Missing of int  (** no process has the leaf *)
  | In_process of int * (State.process -> bool)
  (** a predicate of the process that has the leaf; this and the next two are false for an absorbed leaf *)
  | In_behaviour of int * (Behaviour.aged -> bool)
  (** a predicate of the behaviour of the leaf; while time passes, only the end of an eps may change it *)
  | Touch of int * int * (Timeline.extent -> Path.t -> Path.t -> Truth.t Timeline.t)
  (** whether the processes that have the leaves touch, which may be one process *)
  | Rest of (State.t -> bool)
  (** whether nothing ever happens again; it stays the same while time passes and nothing happens *)
  | Arrival of Property.event  (** such a transition has just led here, and no time has passed since *)

val of_the_gone : Model.t -> int -> string
(** The reason, for messages, why a quantity of an absorbed leaf is undefined (rule Absorb). *)

val quantity : Model.t -> Property.quantity -> quantity
(** The meaning of an atom that is a number. Lengths, velocities and momenta are in the world frame. *)

val fact : Semantics.t -> Property.fact -> fact
(** The meaning of an atom that is a truth. *)

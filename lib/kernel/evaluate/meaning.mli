(** What each atom means, written once: as what has to be looked at, and what is made of it. Who has a state, a
    tuple of numbers or a stretch of time at hand ({!Terms.View}) looks at that, and restates nothing. *)

open Scc_ctl
open Scc_calculus
open Scc_semantics
open Scc_motion
open Scc_property

type quantity =
  | Of_process of int * (Path.t -> Path.curve)
  (** of the process that has the leaf; of who is gone, {!of_the_gone} *)
  | Counted of int * (State.process -> int)
  (** of the process that has the leaf, 0 of who is gone; does not change while time passes *)
  | Of_two of int * int * (Path.t -> Path.t -> Path.curve)  (** of those that have the leaves, which may be one *)
  | Sum of (Path.t -> Path.curve)  (** over all processes *)
  | Number of (State.process -> int)  (** the same, of what does not change while time passes *)
  | Time  (** absolute *)
  | Parameter of int  (** of which a range is known: one run has its value in its place *)

type fact =
  | Missing of int  (** no process has the leaf *)
  | In_process of int * (State.process -> bool)  (** of the process that has the leaf; false of who is gone, as
                                                     all that follows *)
  | In_behaviour of int * (Behaviour.aged -> bool)
  (** of the behaviour of the leaf; time that passes, but for the end of an eps, changes nothing of it *)
  | Between of int * int * (Timeline.extent -> Path.t -> Path.t -> Truth.t Timeline.t)
  (** of the processes that have the leaves, which may be one *)
  | In_network of (State.t -> bool)  (** does not change while time passes and nothing happens *)
  | Arrival of Property.event  (** such a transition has just led here, and no time has passed since *)

val of_the_gone : Model.t -> int -> string
(** Why there is no number that tells where a leaf is that is gone (rule Absorb). *)

val quantity : Model.t -> Property.quantity -> quantity
val fact : Semantics.t -> Property.fact -> fact

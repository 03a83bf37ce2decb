(** Sums over all processes along a run, such as numbers of bonds. They follow the run by what its transitions
    replace, so that the cost of a step does not depend on the size of the network. *)

open Scc_calculus
open Scc_semantics
open Scc_property

type t

val make : Semantics.t -> Atom.t list -> t
(** The sums among these atoms ({!Atom.t.total}), before any state. *)

val count : t -> State.t -> unit
(** [count t s] computes all sums in [s], in time proportional to its size. *)

val is_empty : t -> bool
(** [is_empty t] is true if there is no sum. *)

val replace : t -> gone:State.process list -> come:State.process list -> unit
(** [replace t ~gone ~come] is the sums after a transition that replaces the processes [gone] by [come]. *)

val value : t -> Property.quantity -> int option
(** The value of a sum now; [None] if it is not among those of [t]. *)

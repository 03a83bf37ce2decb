(** The reductions of an exploration over zones for some formulas, except slices ({!Zone_slice}). *)

open Scc_calculus
open Scc_property
open Scc_verify

val displaced : Setup.t -> Model.t -> State.t -> Property.temporal list -> bool
(** [displaced options m s formulas] is true if the place of the whole does not matter (rule Translation). *)

val visible : Setup.t -> Property.temporal list -> (int -> bool) option
(** The leaves that can be observed, if independent events of one instant need only be followed in one order
    (rule Order). [None] if all orders are needed. *)

val interchangeable : Setup.t -> Model.t -> State.t -> Property.temporal list -> int list list
(** Classes of leaves that may be exchanged (rule Symmetry), for searches only; else none. *)

(** Which reductions are used of an exploration over zones for some formulas, slices apart ({!Zone_slice}). *)

open Scc_calculus
open Scc_property

val displaced : Joint_check.options -> Model.t -> State.t -> Property.temporal list -> bool
(** Where the whole is does not matter (rule Translation). *)

val visible : Joint_check.options -> Property.temporal list -> (int -> bool) option
(** The leaves that can be seen, where independent events of one instant need only be followed in one order (rule
    Order). *)

val interchangeable : Joint_check.options -> Model.t -> State.t -> Property.temporal list -> int list list
(** Classes of leaves of which it does not matter which is where (rule Symmetry): for searches alone. *)

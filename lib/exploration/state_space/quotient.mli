(** States that need not be told apart. *)

open Scc_calculus
open Scc_property

type t = {
  symmetry : Symmetry.t;
  translation : bool;  (** moved as a whole, a network is the same *)
  drift : Drift.t option;  (** how far bodies that never meet again are from each other makes no difference *)
}

val none : t

val translatable : Model.t -> State.t -> Property.temporal list -> bool
(** Whether nothing depends on where the whole is: no law and no formula speaks of positions, and nothing is
    fixed. *)

(** {1 Of the tuples of a catalogue} *)

type within

val within : t -> Catalogue.t -> within

val is_none : within -> bool
(** Each state stands for itself alone. *)

val representative : within -> int array -> int array
(** Of the states that are equal to one, the one that stands for them all; the same array, if that is it. *)

val same_but_for_places : within -> int array -> int array -> bool
(** Two states under the same names that differ in nothing but in how far those are from each other that never meet
    again. *)

val keeps : within -> int array -> Property.quantity -> bool
(** Whether its value in a state of the graph is that in each state that this one stands for. *)

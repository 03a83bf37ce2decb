(** States that need not be told apart. *)

open Scc_calculus
open Scc_property

type t = {
  symmetry : Symmetry.t;
  translation : bool;  (** moved as a whole, a network is the same *)
}

val none : t

val translatable : Model.t -> State.t -> Property.temporal list -> bool
(** Whether nothing depends on where the whole is: no law and no formula speaks of positions, and nothing is
    fixed. *)

val representative : t -> Catalogue.t -> int array -> int array
(** Of the states that are equal to one, the one that stands for them all. *)

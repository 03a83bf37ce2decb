(** Interchangeable leaves. Leaves of one shape, mass and law differ in nothing but their names and what the
    state says of them; to rename them in a state changes no transition but for the names in its label (reading
    I-17 has nothing to say here: behaviours do not name leaves). No two of them are in one place, so that their
    places put them in order: a state is put into canonical form by sorting, without search.

    Renaming is an automorphism of the transition system, and so a state and its canonical form are bisimilar,
    times included: every formula that the renaming leaves as it is has one value in both (rule Symmetry). *)

open Scc_calculus
open Scc_property

type t
(** Classes of interchangeable leaves. *)

val none : t
val is_none : t -> bool

val find : Model.t -> initial:State.t -> searched:Property.temporal list -> evaluated:Property.temporal list -> t
(** Among the leaves of the initial state. Fixed ones are left alone, and so are those that an event names, or a
    formula of [evaluated], whose parts are explained one by one. A formula of [searched] may name leaves when each
    search that it is made of stays the same, but for the order of what is symmetric, whichever of them change
    places. *)

val classes : t -> int list list
(** Of two or more leaves. *)

val canonical : t -> ((State.process -> unit) -> unit) -> (int -> int) option
(** [canonical s each]: how the leaves of a state, whose processes [each] goes through, are to be renamed, so that
    interchangeable ones are in the order of their places, and those of a class that are gone are its last; [None]
    when they are in that order already. *)

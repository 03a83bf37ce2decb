(** Interchangeable leaves. Leaves of one shape, mass and law differ only in their names and in the state. To
    rename them in a state changes only the names in the labels of its transitions. Behaviours do not name
    leaves, so reading I-17 is not concerned. No two leaves are in one place, so their places put them in order:
    sorting, without search, gives the canonical form of a state.

    Renaming is an automorphism of the transition system. So a state and its canonical form are bisimilar, times
    included. Every formula that is invariant under the renaming has the same value in both (rule Symmetry). *)

open Scc_calculus
open Scc_property

type t
(** Classes of interchangeable leaves. *)

val none : t
(** No classes: no two leaves are interchangeable. *)

val is_none : t -> bool
(** [is_none s] is true if there are no classes. *)

val find : Model.t -> initial:State.t -> searched:Property.temporal list -> evaluated:Property.temporal list -> t
(** [find m ~initial ~searched ~evaluated] is the classes among the leaves of [initial]. Excluded are fixed
    leaves, leaves that an event names, and leaves that a formula of [evaluated] names, as its parts are
    explained one by one. Leaves that a formula of [searched] names are interchangeable only if exchanging them
    keeps each search of the formula, up to the order of what is symmetric. *)

val classes : t -> int list list
(** The classes, each of two or more leaves, as increasing indices. *)

val canonical : t -> ((State.process -> unit) -> unit) -> (int -> int) option
(** [canonical s each] is the renaming of leaves that makes a state canonical; [None] if it is so already. [each
    f] calls [f] for all processes of the state. In canonical form, the leaves of a class are in the order of
    their places, and those that were absorbed come last. *)

(** Bodies that never meet again (rule Drift): how far apart groups of processes are is not told apart when, along
    some direction, they are apart and get farther for ever, whatever happens within them.

    {1 Which groups}

    Each group has a velocity: that of its centre of mass, or 0 when something in it is fixed. Binds, bounces and
    splits never add kinetic energy, so that no leaf of it is ever faster against that velocity than its energy in
    this frame allows. Two groups are apart when they recede from each other for ever
    ({!Recession.for_ever}). The groups of a
    state are the finest partition of its processes of which each two are apart: whatever happens next, groups of
    what comes of them are as fine at least, so that the groups of two states that differ by translations of groups
    go on to be those of two such states.

    {1 What formulas see}

    Coordinates and distances that are compared with constants count up to these: groups are apart only where all
    such distances between them are, and stay, beyond them; and where a coordinate of a group is not, and does not
    stay, beyond its constants, the group is not moved. *)

open Scc_exact
open Scc_calculus
open Scc_property

type t

val make : Model.t -> State.t -> Property.check list -> t option
(** What keeps the truth of all that is asked. Only where bodies move in straight lines, without laws and rounding,
    and something may go on when some never meet others any more: a weak split or an eps is still to come, or, as
    somebody is outside of it at the start, collisions within what is fixed. *)

val sees_far : Model.t -> State.t -> Property.check list -> bool
(** Some coordinate or distance is told apart without limits, and that keeps an exploration from closing as a rule:
    {!make} would be of use otherwise, and some are apart for ever from the start. *)

val groups : t -> State.process array -> int list list
(** Which are apart for ever, by their places in the array. *)

val is_held : t -> State.process -> bool
(** It is fixed, or a point of it is within the convex hull of what is fixed, so that it is not apart from that.
    Where all are, nobody is moved. *)

val place : t -> State.process array -> (int * Vec.t) list
(** By how much processes, by their places in the array, are to be moved, so that of two states that differ by
    translations of groups one comes. *)

val keeps : t -> State.process array -> Property.quantity -> bool
(** Whether it has its value in each state that another one of these groups stands for. *)

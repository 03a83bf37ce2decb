(** Bodies that never meet again (rule Drift). Two groups of processes may recede from each other along some
    direction for ever, whatever happens within them. States that differ only in the distances of such groups are
    equivalent.

    {1 Which groups}

    Each group has a velocity: that of its centre of mass, or 0 if a body in it is fixed. Binds, bounces and
    splits never add kinetic energy. So the energy of the group in the frame of this velocity bounds the speed of
    all its leaves in that frame. Two groups are apart if they recede from each other for ever
    ({!Recession.for_ever}).

    The groups of a state are the finest partition of its processes in which any two groups are apart. The groups
    of all later states are at least as fine. So two states that differ by translations of groups have successors
    that differ by translations of groups.

    {1 What formulas depend on}

    Formulas compare coordinates and distances with constants. Two groups are apart only if all such distances
    between them are beyond these constants, and stay so. A group is translated only if all such coordinates of
    it are beyond their constants, and stay so. *)

open Scc_exact
open Scc_calculus
open Scc_property

type t

val make : Model.t -> State.t -> Property.check list -> t option
(** [make m initial checks] is the equivalence that keeps the truth of all [checks]; [None] where the rule does
    not apply. It applies if bodies move in straight lines, without laws and rounding, if splits are on a grid,
    and if no check depends on an angular momentum. Besides, events must be possible for bodies that never meet
    others. For that, a weak split or an eps is written in the model, or there are fixed bodies, whose convex
    hull has a volume, to collide with. *)

val sees_far : Model.t -> State.t -> Property.check list -> bool
(** [sees_far m initial checks] is true if the checks depend on a coordinate or a distance without limits, where
    {!make} would be of use otherwise, and some groups are apart from the start. As a rule, such an exploration
    does not close. *)

val groups : t -> State.process array -> int list list
(** The groups of some processes that are all the processes of a state, as lists of indices into the array, in
    order. *)

val is_held : t -> State.process -> bool
(** [is_held d p] is true if [p] is fixed, or if a corner of it is in the convex hull of all fixed bodies. Then
    [p] is not apart from these. It is false if that hull has no volume. If all processes are held, no group is
    translated. *)

val place : t -> State.process array -> (int * Vec.t) list
(** [place d processes] is the translations that lead to the representative of a state, as indices into
    [processes] and vectors in the world. Two states that differ by translations of groups have one
    representative. *)

val keeps : t -> State.process array -> Property.quantity -> bool
(** [keeps d processes q] is true if [q] has one value in all states that differ from this one by translations of
    groups. *)

(** Slicing: the processes that cannot influence a search are left out of the network.

    A slice is the initial state with fewer processes; the model, the numbers of leaves and the formulas stay as
    they are, and leaves that are left out are in no process.

    {1 Which formulas}

    Searches only (EF and AG of state predicates from now on, with or without a bound of time, predicates of the
    initial state, and what [not], [and] and [or] make of them: {!Plan} without a formula for the graph), which
    name a leaf and have no global atom (Formula.global). Which transitions are made elsewhere at an instant
    must not matter, so events may only count in favour of what is searched for: an unrelated transition at the
    same instant ends what an atom [event] says. Not with laws of motion: the steps of movement, and who is
    steered when, are shared by all.

    {1 Why it is sound}

    Processes act upon each other by collisions alone. Processes are put in groups such that in no run, up to
    the horizon of the formulas, two processes of different groups collide; those left out are whole groups.
    Then up to the horizon

    - the run of the kept processes within a run of the whole is a run of the slice: it stops less often, which
      by additivity of time changes nothing (split clocks and horizons are the processes' own);
    - a finite run of the slice is that of the kept processes within a run of the whole, in which those left out
      make their urgent transitions when time could not pass otherwise. This needs one run of theirs in which
      time gets to the horizon. What does not collide at all splits finitely often and has finitely many delays
      in a finite time. What may collide could bind and split for ever within an instant, or within a finite
      time: such a group is run by itself to the horizon, always by the first urgent transition, and left out
      only if it gets there.

    {!Lift} makes the run of the whole, and takes exactly the transitions that are taken here.

    {1 Who may meet whom}

    A process that has not collided moves in a straight line; so do the pieces that it splits into. Two
    processes on their lines collide at a rational time that is found exactly (rule Ftoc). As soon as a group
    may have a collision, with itself or with a wall, its velocities are no longer known; but binds and bounces
    never add kinetic energy, and so nothing of a group with the energy E moves a leaf of mass m faster than the
    root of 2E/m: its place is its box, grown by as much as it may move until the horizon. Every process that
    such a box meets, wherever it is at any time up to the horizon, joins the group. A fixed leaf never moves.

    A wall is a fixed leaf, without bonds, that offers no channel to bind with, now or later: nothing that
    happens changes it. It joins no groups together, but is kept with every kept group that may reach it. One
    that an event of a formula names is no wall in this sense. *)

open Scc_calculus
open Scc_semantics
open Scc_property

val make : Semantics.t -> initial:State.t -> Property.temporal list -> State.t option
(** The slice of an initial state for all the formulas together; [None] when nothing can be left out, or a
    formula is not of the fragment. *)

val favours_events : Property.temporal -> bool
(** A search in which events only count in favour of what is searched for: others of the same instant, which end
    what an atom [event] says, hide nothing from it. *)

val can_be_sliced : Property.temporal -> bool
(** It is of the fragment. *)

val is_wall : Model.t -> in_events:int list -> State.process -> bool
(** Nothing that happens changes it; [in_events] are the leaves that events of the formulas name. *)

val left_out : Model.t -> initial:State.t -> State.t -> string list
(** The names of the leaves that a slice does not have, in order. *)

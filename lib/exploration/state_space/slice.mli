(** Slicing: processes that cannot influence a search are left out of the network.

    A slice is the initial state with fewer processes. The model, the numbers of leaves and the formulas stay as
    they are. Leaves that are left out are in no process.

    {1 Which formulas}

    - Searches: EF and AG of state predicates from now on, with or without a bound of time, predicates of the
      initial state, and combinations of these by [not], [and] and [or].
    - Probabilities of F, G and U of state predicates, as a result or compared with a number, and the mean of a
      number at a time. Operators within others are excluded: while a process that is left out waits to draw, a
      body that has drawn still has its old velocity, but its future is decided. A formula that depends on both
      at once depends on the presence of others.

    All of them name a leaf and have no global atom ([Formula.global]). The transitions elsewhere at an instant
    must not matter. An unrelated transition at the same instant makes an atom [event] false. So events may only
    count in favour of what is searched for. They may not be counted, nor be required all the way ([f] of [f U
    g]). The horizon of the formulas is {!Scc_property.Plan.latest_horizon}.

    {1 Which models}

    Translational models without pushes, lots, rounding and binding by contact (reading I-33), with laws of
    motion that {!Pace.allows}.

    {1 Why it is sound}

    Processes act upon each other by collisions alone. They are partitioned into groups. In no run, up to the
    horizon of the formulas, do two processes of different groups collide. What is left out is whole groups. Then
    the following holds up to the horizon.

    - The run of the kept processes within a run of the whole is a run of the slice. It stops less often, which
      by additivity of time changes nothing: split clocks and horizons belong to single processes.
    - A finite run of the slice is that of the kept processes within a run of the whole. In that run, the
      processes that are left out make their urgent transitions when time could not pass otherwise.

    The second point needs one run of the groups that are left out in which time gets to the horizon. A group
    without collisions splits finitely often and has finitely many delays in a finite time, unless rings may open
    and close again. A group with collisions could bind and split for ever within an instant, or within a finite
    time. Such a group is run by itself to the horizon, always by the first urgent transition. It is left out
    only if this run gets there.

    [Scc_explain.Lift] makes the run of the whole, and takes exactly the transitions that are taken here.

    {2 With laws of motion}

    All processes share the instants at which laws are evaluated. A collision ends the movement step of all. Even
    where steps keep their beat, a collision puts off what is due at its instant. So bonds of other processes may
    be released before these are steered, and not after. Under laws, therefore, only groups without any collision
    up to the horizon are left out. Then the laws of the kept processes are evaluated at the same instants as in
    the whole.

    Their draws are independent of those of other processes. Other draws take no time, come between theirs, and
    change nothing but this: velocities take effect with the last draw of all. Until then, each process that
    draws is in its place with its old velocity, as before its own last draw. {!Pace.allows} has the reason why
    either all laws draw or none.

    {2 For probabilities}

    Each scheduler of the slice is a scheduler of the whole: processes that are left out make their first
    transition when they must, and draw by themselves. A scheduler of the whole chooses for the kept processes by
    what it knows of all. Seen from the kept ones, it chooses at random. That gains nothing, for the greatest
    probability or mean as well as for the least. But a scheduler might let other processes cycle for ever within
    an instant, so that time stops for all. So for probabilities, too, only groups without a collision are left
    out, in all runs of which time goes on.

    {1 Which processes may meet}

    A process that has not collided, and is under no law, moves in a straight line; so do the pieces that it
    splits into. Two processes on their lines collide at a rational time that is found exactly (rule Ftoc).

    The velocities of a group are unknown once it may have a collision, with itself or with a wall, or if it has
    a leaf under a law. But {!Pace.energy} bounds twice its energy by some E. So nothing of it moves a leaf of
    mass m faster than the root of E/m. The place of the group is its box, grown by as much as it may move until
    the horizon. Every process that meets such a box, at any time up to the horizon, joins the group. A fixed
    leaf never moves. Pieces of one process that a law moves may meet each other.

    A wall is a fixed leaf, without bonds, that offers no channel to bind with, now or later: nothing that
    happens changes it. It joins no groups together, but is kept with every kept group that may reach it. A leaf
    that an event of a formula names is no wall in this sense. *)

open Scc_calculus
open Scc_semantics
open Scc_property

val make : Semantics.t -> initial:State.t -> Property.temporal list -> State.t option
(** [make c ~initial formulas] is the slice of [initial] for all [formulas] together. It is [None] if only walls
    can be left out, or if the model or a formula is none of those above. Applied to [c] and [initial] alone, it
    makes a cache of the groups for each horizon, which all later lists of formulas use. *)

val favours_events : Property.temporal -> bool
(** [favours_events f] is true if [f] is a search in which events only count in favour of what is searched for.
    Other transitions of the same instant, which make an atom [event] false, hide nothing from such a search. *)

val can_be_sliced : Property.temporal -> bool
(** [can_be_sliced f] is true if [f] is one of the searches above: {!favours_events}, with a leaf and without
    global atoms. *)

val is_wall : Model.t -> in_events:int list -> State.process -> bool
(** [is_wall m ~in_events p] is true if [p] is a wall: nothing that happens changes it. [in_events] is the leaves
    that events of the formulas name. *)

val left_out : Model.t -> initial:State.t -> State.t -> string list
(** [left_out m ~initial slice] is the names of the leaves that [initial] has and [slice] has not, in order. *)

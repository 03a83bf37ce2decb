(** Slicing: the processes that cannot influence a search are left out of the network.

    A slice is the initial state with fewer processes; the model, the numbers of leaves and the formulas stay as
    they are, and leaves that are left out are in no process.

    {1 Which formulas}

    - Searches: EF and AG of state predicates from now on, with or without a bound of time, predicates of the
      initial state, and what [not], [and] and [or] make of them.
    - Probabilities of F, G and U of state predicates, asked for or compared with a number, and the mean of a
      number at a time. Not operators within others: while somebody who is left out waits to draw, a body that
      has drawn still has its old velocity, but its future is decided; a formula that sees both at once sees
      whether others are there.

    All name a leaf and have no global atom (Formula.global). Which transitions are made elsewhere at an instant
    must not matter, so events may only count in favour of what is looked for: an unrelated transition at the
    same instant ends what an atom [event] says. So events are not counted, nor asked for all the way ([f] of [f
    U g]). How far formulas look is {!Plan.latest_horizon}.

    {1 Which models}

    Translational ones without pushes and without binding by contact (reading I-33), whose laws of motion
    {!Pace.allows}.

    {1 Why it is sound}

    Processes act upon each other by collisions alone. Processes are put in groups such that in no run, up to
    the horizon of the formulas, two processes of different groups collide; those left out are whole groups.
    Then up to the horizon

    - the run of the kept processes within a run of the whole is a run of the slice: it stops less often, which
      by additivity of time changes nothing (split clocks and horizons are the processes' own);
    - a finite run of the slice is that of the kept processes within a run of the whole, in which those left out
      make their urgent transitions when time could not pass otherwise. This needs one run of theirs in which
      time gets to the horizon. What does not collide at all splits finitely often and has finitely many delays
      in a finite time, but where rings may open and close again. What may collide could bind and split for ever
      within an instant, or within a finite time: such a group is run by itself to the horizon, always by the
      first urgent transition, and left out only if it gets there.

    {!Lift} makes the run of the whole, and takes exactly the transitions that are taken here.

    {2 With laws of motion}

    Who is asked for a new velocity, and when, is shared by all: a collision ends the movement step of all, and
    even where steps keep their beat, it puts off to after it what is due at its instant, so that bonds of
    others may be released before they are steered and not after. So here only groups are left out that have no
    collision at all up to the horizon. Then the kept are asked at the same instants as in the whole. Their
    draws are independent of those of the others, which take no time, come between theirs and change nothing:
    but that velocities take effect by the last draw of all. Until then who is asked is where it is, with its
    old velocity, as it is before its own last draw; {!Pace.allows} tells why this takes that all laws draw, or
    none.

    {2 For probabilities}

    Each scheduler of the slice is one of the whole: those left out make their first transition when they must,
    and draw by themselves. A scheduler of the whole chooses for the kept by what it knows of all: seen from
    them, it chooses at random, and nothing is gained by that, neither for the greatest probability or mean nor
    for the least. But a scheduler might let others go round for ever within an instant, so that what is still
    to come never does: so here as well, only groups without a collision are left out, in all of whose runs time
    goes on.

    {1 Who may meet whom}

    A process that has not collided, and is under no law, moves in a straight line; so do the pieces that it
    splits into. Two processes on their lines collide at a rational time that is found exactly (rule Ftoc). As
    soon as a group may have a collision, with itself or with a wall, or has a leaf under a law from the start,
    its velocities are no longer known; but {!Pace.energy} bounds twice its energy by some E, and so nothing of
    it moves a leaf of mass m faster than the root of E/m: its place is its box, grown by as much as it may move
    until the horizon. Every process that such a box meets, wherever it is at any time up to the horizon, joins
    the group. A fixed leaf never moves. Pieces of one process that a law moves may meet each other.

    A wall is a fixed leaf, without bonds, that offers no channel to bind with, now or later: nothing that
    happens changes it. It joins no groups together, but is kept with every kept group that may reach it. One
    that an event of a formula names is no wall in this sense. *)

open Scc_calculus
open Scc_semantics
open Scc_property

val make : Semantics.t -> initial:State.t -> Property.temporal list -> State.t option
(** The slice of an initial state for all the formulas together; [None] when nothing but walls can be left out,
    or a formula or the model is none of those above. Given a model and a state, it remembers who may meet whom
    up to a horizon for the lists of formulas that follow. *)

val favours_events : Property.temporal -> bool
(** A search in which events only count in favour of what is searched for: others of the same instant, which end
    what an atom [event] says, hide nothing from it. *)

val can_be_sliced : Property.temporal -> bool
(** It is one of the searches above. *)

val is_wall : Model.t -> in_events:int list -> State.process -> bool
(** Nothing that happens changes it; [in_events] are the leaves that events of the formulas name. *)

val left_out : Model.t -> initial:State.t -> State.t -> string list
(** The names of the leaves that a slice does not have, in order. *)

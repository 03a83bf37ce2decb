(** Rule Turn: how the processes of a rigid model turn. In the translational calculus nothing turns; {!pass},
    {!velocity_at}, {!due}, {!begun}, {!left} and {!ended} are valid there as well.

    A process moves as one rigid body. Its centre of mass moves in a straight line, and all of it turns about
    that centre by the Cayley map of its spin ({!Scc_rigid.Motion}). The map is not additive in time, so a
    process has turns. A turn begins when another is over, and when something happens to the process. The state
    has the time since it began. Between the end of a turn and the beginning of the next, in one instant, a turn
    is {!due}. *)

open Scc_exact
open Scc_calculus
open Scc_rigid

val rigid : Model.t -> Model.rigid
(** The settings of a rigid model. A translational model is a bug. *)

val spinning : State.process -> bool
(** [spinning p] is true if the spin of [p] is not zero. *)

val velocity_at : Model.t -> State.process -> Vec.t -> Vec.t
(** [velocity_at m p x] is the velocity of the point of [p] that is now at [x]: v + w x r, in the world. *)

val pass : Model.t -> Rat.t -> State.process -> State.process
(** [pass m d p] is [p] moved by a time d, if nothing happens meanwhile. It is valid within the present turn, and
    for d < 0 if [p] does not spin. Behaviours and clocks stay as they are. *)

(** {1 Spin and angular momentum}

    With [constant_spin] a process keeps its spin. With [free_body] it keeps its angular momentum L (the field
    [kept] of [State.process]), and has one spin for each turn. This is the spin that L gives half-way through
    the turn, estimated from that at its start (the explicit midpoint rule, of second order). Collisions, bonds
    and splits use the spin that L gives at their own instant: the instantaneous spin. *)

val is_free : Model.t -> bool
(** [is_free m] is true if [m] is rigid with [free_body]. *)

val mass_from_first : Model.t -> State.process -> Mass.t option
(** The mass, centre of mass and inertia of a process in the frame of its first leaf, where they stay the same as
    the process moves and turns. [None] for a fixed process. *)

val mover : Model.t -> State.process -> Impact.mover
(** The mass of a process as it is now in the world, its velocity, and its instantaneous spin. *)

val renew : Model.t -> State.process -> State.process
(** The process with a new turn due, and with its instantaneous spin. *)

val start : Model.t -> State.process -> State.process
(** The process with a new turn due. In a model with [free_body], it keeps from now on the angular momentum that
    follows from its spin. *)

val moving : Model.t -> Impact.mover -> State.process -> State.process
(** [moving m mover p] is [p] with the velocity and spin of [mover], and a new turn due ({!start}). *)

val spun : Model.t -> Vec.t -> State.process -> State.process
(** [spun m spin p] is [p] with this spin, given by a law (rule Steer), and a new turn due ({!start}). *)

val piece : Model.t -> whole:State.process -> State.process -> State.process
(** [piece m ~whole p] is [p], a piece of [whole] that has just split off, in the motion that the whole had, with a
    new turn due (reading I-11). *)

(** {1 Turns that begin and end} *)

val length : Model.t -> Vec.t -> Rat.t
(** [length m spin] is the length of a turn about [spin], a time. It is Delta / 2^k for the least k >= 0 such
    that a process turns by at most 2 atan(1/4), about 28 degrees; 0 for no spin. The angle of a turn of length d
    is 2 atan(|spin| d / 2), less than |spin| d by at most one part in 48. *)

val due : State.process -> bool
(** [due p] is true if a turn of [p] is due to begin. The process is then at the start of it, with its
    instantaneous spin. *)

val begun : Model.t -> State.process -> State.process
(** The process at the start of a turn about its present spin. *)

val midway : Model.t -> State.process -> State.process option
(** The process at the start of a turn about the spin that its angular momentum gives it half-way through that
    turn. Its turn must be due. The result is [None] if the process is not free or does not spin. Estimates of
    spins have 40 bits: they are rounded to the nearest multiples of 2^(e - 40), where 2^e <= the greatest
    component < 2^(e + 1). *)

val left : State.process -> Rat.t option
(** The time left in the present turn: 0 while a turn is due, and [None] if the process does not spin. *)

val goes_on : State.process -> bool
(** [goes_on p] is true if [p] spins, in a turn that has begun. A collision ends such a turn. *)

val ended : Model.t -> State.process -> State.process
(** The process with a new turn due, if its present turn is over; else the process itself. *)

val motion : Model.t -> State.process -> centre:Vec.t -> State.leaf -> int -> Motion.t
(** [motion m p ~centre leaf i] is the motion of part [i] of a leaf of [p] in its present turn. The centre of
    mass of [p] is at [centre], in the world. *)

val reach : Model.t -> centre:Vec.t -> State.leaf -> int -> Rat.t
(** [reach m ~centre leaf i] is an upper bound on the distance of the points of part [i] from [centre]. It stays
    the same as the part turns about [centre]. *)

(** Rule Turn: how the processes of a rigid model turn (the rigid calculus; in the translational one nothing
    turns, and none of this is asked).

    A process moves as one rigid body: its centre of mass in a straight line, and all of it about that centre by
    the Cayley map of its spin ({!Scc_rigid.Motion}). The map is not additive in time, so that a process has turns:
    one begins when another is over, and when something happens to the process. It remembers how long ago that
    was. Between the end of a turn and the begin of the next, in one instant, a turn is {!due}. *)

open Scc_exact
open Scc_calculus
open Scc_rigid

val rigid : Model.t -> Model.rigid
(** Of a model that is rigid (a bug otherwise). *)

val half : Rat.t
val spinning : State.process -> bool

val velocity_at : Model.t -> State.process -> Vec.t -> Vec.t
(** Of the point of the process that is now at a place. *)

val pass : Model.t -> Rat.t -> State.process -> State.process
(** Where the process is after a time d, if nothing happens meanwhile; a process that does not spin also where it
    was, for d < 0. *)

(** {1 Spin and angular momentum}

    With [constant_spin] a process keeps its spin. With [free_body] it keeps its angular momentum L (the field
    [kept] of {!State.process}), and has one spin for each turn: that which L gives half-way through the turn,
    estimated from that at its start (the explicit midpoint rule, of second order). Collisions, bonds and splits
    see the spin that L gives at that instant. *)

val is_free : Model.t -> bool
(** [free_body]. *)

val mass_from_first : Model.t -> State.process -> Mass.t option
(** As seen from its first leaf: it does not change as the process moves and turns. [None] for a fixed process. *)

val mover : Model.t -> State.process -> Impact.mover
(** Its mass, where that is now, velocity, and the spin that collisions see. *)

val renew : Model.t -> State.process -> State.process
(** The process with a new turn due, and the spin that collisions see. *)

val start : Model.t -> State.process -> State.process
(** The process with a new turn due; from now on it keeps the angular momentum that its spin gives it. *)

val moving : Model.t -> Impact.mover -> State.process -> State.process
(** The process with another velocity and spin, and a new turn due. *)

val piece : Model.t -> whole:State.process -> State.process -> State.process
(** A piece of a process that has just split, in the motion that the whole had, with a new turn due
    (reading I-11). *)

(** {1 Turns that begin and end} *)

val length : Model.t -> Vec.t -> Rat.t
(** Of a turn about a spin: Delta / 2^k for the least k >= 0 such that a process turns by no more than 2 atan(1/4),
    about 28 degrees, in it; 0 for no spin. The angle of a turn of length d is 2 atan(|spin| d / 2), less than
    |spin| d by at most one part in 48. *)

val due : State.process -> bool
(** A turn of the process is due to begin: it is at the start of it, with the spin that collisions see. *)

val begun : Model.t -> State.process -> State.process
(** The process at the start of a turn about the spin that it has. *)

val midway : Model.t -> State.process -> State.process option
(** The process, due to turn, at the start of a turn about the spin that its angular momentum gives it half-way
    through that turn, if it is free and spins. Estimates of spins have 40 bits: they are rounded to the
    nearest multiples of 2^(e - 40), where 2^e <= the greatest component < 2^(e + 1). *)

val left : State.process -> Rat.t option
(** The time left in the turn of what spins; none of it is left while one is due. *)

val goes_on : State.process -> bool
(** Whether the process turns on a turn that has begun, and that a collision ends. *)

val ended : Model.t -> State.process -> State.process
(** The process, with a new turn due if its turn is over. *)

val motion : Model.t -> State.process -> centre:Vec.t -> State.leaf -> int -> Motion.t
(** [motion m p ~centre leaf i]: of part [i] of a leaf of the process, whose centre of mass is at [centre]. *)

val reach : Model.t -> centre:Vec.t -> State.leaf -> int -> Rat.t
(** An upper bound on the distance of the part's points from the centre; turning does not change it. *)

(** Rule Turn: how the processes of a rigid model turn (the rigid calculus; in the translational one nothing
    turns, and none of this is asked).

    A process moves as one rigid body: its centre of mass in a straight line, and all of it about that centre by the
    Cayley map of its spin ({!Scc_rigid.Motion}). A turn begins with a movement step, at a contact, and for the
    pieces of a split; the map is not additive in time, so that a process remembers how long ago its turn began. *)

open Scc_exact
open Scc_calculus
open Scc_rigid

val rigid : Model.t -> Model.rigid
(** Of a model that is rigid (a bug otherwise). *)

val half : Rat.t
val spinning : State.process -> bool

val pass : Model.t -> Rat.t -> State.process -> State.process
(** Where the process is after a time d >= 0, if nothing happens meanwhile. *)

val renew : Model.t -> State.process -> State.process
(** The process at the start of a new turn: with [constant_spin] its spin is what it was; with [free_body] it is
    computed from the angular momentum that the process had at the start of the last turn. *)

val piece : Model.t -> whole:State.process -> State.process -> State.process
(** A piece of a process that has just split, in the motion that the whole had, at the start of a new turn
    (reading I-11). *)

val step_length : Model.t -> State.t -> Rat.t
(** The length of a movement step that begins in a state: Delta / 2^k for the least k >= 0 such that no process turns
    by more than 2 atan(1/4), about 28 degrees, in it. The angle by which a process turns in a step of length d is
    2 atan(|spin| d / 2), less than |spin| d by at most one part in 48. *)

val shortened : State.t -> State.t
(** The state with what is left of its movement step halved as often as it takes for that to be true again: a
    collision of an instant that has been steered already, and a turn of a free body that begins within a step,
    give spins that the step was not made for. *)

val motion : Model.t -> State.process -> centre:Vec.t -> State.leaf -> int -> Motion.t
(** [motion m p ~centre leaf i]: of part [i] of a leaf of the process, whose centre of mass is at [centre]. *)

val reach : Model.t -> centre:Vec.t -> State.leaf -> int -> Rat.t
(** An upper bound on the distance of the part's points from the centre; it does not change as the process turns. *)

val mover : Model.t -> State.process -> Impact.mover
(** Its mass, where that is now, velocity and spin. *)

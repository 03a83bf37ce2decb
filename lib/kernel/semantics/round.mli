(** Rule Round: the one place where the numbers of a model are rounded, when it asks for that: as turns begin. *)

open Scc_calculus

val involves : int -> int * int -> bool
(** Whether a process, by its index, is one of two. *)

val at_once :
  colliding:(State.t -> (int * int) list) -> State.t -> (int * State.process) list ->
  State.t * (int * State.process) list
(** Changes of processes, by their indices, made all at once; and which were made. Those of two processes that
    would collide then are not, and that again until no process that is changed collides. [colliding] tells
    which processes collide in a state; none of those to be changed does. *)

val beginning : colliding:(State.t -> (int * int) list) -> State.t -> int list
(** Of the processes that a turn is due of, by their indices, those that do not collide. *)

val begun : Model.t -> State.t -> int list -> State.t
(** With the turns of these begun that are due. *)

type apart = State.t -> (int * Scc_exact.Rat.t) list -> (int * int) list
(** The pairs of processes that are not farther apart than both together may move: those that are listed as far
    as it says, the others not at all. *)

val run : Model.t -> colliding:(State.t -> (int * int) list) -> near:apart -> State.t -> int list -> State.t * bool
(** The state with the orientations of these processes rounded where they are longer than declared, and then their
    velocities and spins; and whether anything changed. None of the processes collides, and a turn of each is due.

    An orientation stays exactly orthogonal, and the process is turned about its centre of mass as a whole. It
    waits for another turn when another process is not farther away than both roundings may move a point.
    Velocities and spins are rounded to the nearest multiples of 2^-k, and what free bodies keep to those of
    2^-k {!Scc_rigid.Mass.scale}. All of it is done {!at_once}. *)

val settled : Model.t -> State.process -> bool
(** Whether rounding is not going to change where the process goes: its velocity and spin are rounded, or never to
    be. *)

(** Rule Round: the one place where the numbers of a model are rounded, if the model has rounding: as turns
    begin. *)

open Scc_calculus

val involves : int -> int * int -> bool
(** [involves i (a, b)] is true if the process with index [i] is one of the pair. *)

val at_once :
  colliding:(State.t -> (int * int) list) -> State.t -> (int * State.process) list ->
  State.t * (int * State.process) list
(** [at_once ~colliding s changes] replaces processes of [s], by their indices, all at once. It drops the changes
    of processes that would then collide, again until no changed process collides. The result is the state and
    the changes that were made. [colliding] is the pairs of processes of a state that collide. No process in
    [changes] may collide in [s]. *)

val beginning : colliding:(State.t -> (int * int) list) -> State.t -> int list
(** The indices of the processes whose turn is due and that do not collide, in order. *)

val begun : Model.t -> State.t -> int list -> State.t
(** [begun m s indices] is [s] after the due turns of these processes have begun. *)

type apart = State.t -> (int * Scc_exact.Rat.t) list -> (int * int) list
(** [near s moves] is the pairs of processes that are not farther apart than both together may move. [moves] has
    the greatest distance that a point of a process moves, by index; processes that are not listed do not move.
*)

val run : Model.t -> colliding:(State.t -> (int * int) list) -> near:apart -> State.t -> int list -> State.t * bool
(** [run m ~colliding ~near s indices] rounds the orientations of these processes, and then their velocities and
    spins, {!at_once} each. The second result is true if anything changed. None of the processes may collide, and
    a turn of each must be due.

    Orientations are rounded where they are longer than the k bits that the model declares. A rounded orientation
    is exactly orthogonal, and the process is turned about its centre of mass as a whole. The rounding is put off
    to a later turn while another process is not farther away than both roundings may move a point. Velocities
    and spins are rounded to the nearest multiples of 2^-k. The angular momenta that free bodies keep are rounded
    to multiples of 2^-k {!Scc_rigid.Mass.scale}. *)

val settled : Model.t -> State.process -> bool
(** [settled m p] is true if rounding will not change the course of [p]. That is so if [p] does not spin, or
    velocities are not rounded, or its velocity and spin (or kept angular momentum) are rounded already. *)

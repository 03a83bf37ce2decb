(** Rule Round: the one place where the numbers of a rigid model are rounded, when it asks for that: as a movement
    step begins. *)

open Scc_exact
open Scc_calculus

val settled : Model.t -> State.process -> bool
(** Whether rounding is not going to change where the process goes: its velocity and spin are rounded, or never to
    be, and so is its orientation if it does not spin. *)

val run :
  Model.t -> collides:(State.t -> bool) -> apart:(State.t -> int -> by:Rat.t -> bool) -> State.t ->
  State.t * bool
(** The state with every orientation that is longer than declared rounded, and every velocity and spin; and whether
    anything changed.

    An orientation stays exactly orthogonal, and the process is turned about its centre of mass as a whole. It
    waits for a later step when another process is not farther away than the rounding may move a point. Velocities
    and spins are rounded to the nearest multiples of 2^-k, and what free bodies keep to those of 2^-k
    {!Scc_rigid.Mass.scale}; they wait when something would collide with them that does not without.

    [collides] tells whether something collides in a state, and [apart] whether a process, by its index, is farther
    than a distance from every other one. *)

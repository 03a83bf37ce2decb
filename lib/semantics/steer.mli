(** Rules Steer and Draw: the laws of motion. *)

open Scc_exact
open Scc_calculus

val steers : Model.t -> State.process -> bool
(** Whether a law that is not inertial moves this process: not when it is bound to a fixed leaf. *)

val velocities :
  Model.t -> time:Rat.t -> dt:(State.leaf -> Rat.t) -> State.process ->
  ((Vec.t * Rat.t) list, Transition.fault) result
(** What the laws of a process may give it, each velocity once, in order, with its chance: positive ones that sum
    to 1. One velocity, where no law leaves anything to chance. *)

type outcome = {
  state : State.t;
  rules : Rule.t list;  (** Steer and Round, if they were used *)
  rounded : State.t option;  (** as in {!Transition.t} *)
}

val settle : Semantics.t -> State.t -> (outcome, Transition.fault) result
(** What is due after a transition. Turns of what collides end (rule Turn). If the movement step is over, this
    instant has not been steered and nothing collides (reading I-15), every process under a law has a new
    velocity, and the next step begins; the time since the last update is what the step has used up (reading
    I-10). Then turns begin of what does not collide (rules Turn and Round). Where laws leave velocities to
    chance, all of that waits until everybody has drawn. *)

val next_to_draw : Semantics.t -> State.t -> State.process option
(** Who draws now; [None] where nobody waits to draw. *)

val draw : Semantics.t -> State.t -> State.process -> ((Transition.label * State.t) list, Transition.fault) result
(** What {!next_to_draw} may draw, in order of velocities, and where that leads before {!settle}. *)

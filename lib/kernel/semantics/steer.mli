(** Rules Steer and Draw: the laws of motion. *)

open Scc_exact
open Scc_calculus

val steers : Model.t -> State.process -> bool
(** Whether a law that is not inertial moves this process: not when it is bound to a fixed leaf. *)

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

val drawers : Semantics.t -> State.t -> State.process list
(** All who wait to draw, in the order in which they do, {!next_to_draw} first: nobody's draw changes it. *)

val chances : Semantics.t -> State.t -> State.process -> ((Vec.t * Rat.t) list, Transition.fault) result
(** What somebody who waits may draw, each velocity once, in order, with its chance: positive ones that sum to 1.
    What others have drawn does not matter. *)

val draw_label : State.process -> Vec.t * Rat.t -> Transition.label

val drawn : (State.process -> Vec.t option) -> State.t -> State.t
(** The state when those of a velocity have drawn it, of those who wait, before {!settle}. *)

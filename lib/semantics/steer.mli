(** Rule Steer: the laws of motion. *)

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
    I-10). Then turns begin of what does not collide (rules Turn and Round). *)

(** Rule Steer: the laws of motion. *)

open Scc_calculus

val steers : Model.t -> State.process -> bool
(** Whether a law that is not inertial moves this process: not when it is bound to a fixed leaf. *)

type outcome = {
  state : State.t;
  rules : Rule.t list;  (** Steer and Round, if they were used *)
  rounded : State.t option;  (** as in {!Transition.t} *)
}

val run : Semantics.t -> State.t -> (outcome, Transition.fault) result
(** New velocities for every process, and a new movement step. The time since the last update is
    what the step has used up (reading I-10). For steered models only. *)

val settle : Semantics.t -> State.t -> (outcome, Transition.fault) result
(** {!run} if the movement step is over, this instant has not been steered and nothing collides (reading
    I-15); and it is as it was otherwise. *)

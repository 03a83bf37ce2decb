(** Rules Steer and Draw: the laws of motion. *)

open Scc_exact
open Scc_calculus

val steers : Model.t -> State.process -> bool
(** [steers m p] is true if a leaf of [p] has a law that is not inertial, and no leaf of [p] is fixed. It is
    {!Process.steers}. *)

val rules : Rule.t list
(** The rules that a transition uses if laws give velocities after it: Steer. *)

type outcome = {
  state : State.t;
  rules : Rule.t list;  (** Steer and Round, if they were used *)
  rounded : State.t option;  (** as in {!Transition.t} *)
}

val settle : Semantics.t -> State.t -> (outcome, Transition.fault) result
(** [settle c s] does what is due after a transition. First, the turns of colliding processes end (rule Turn).
    Then the laws are evaluated, if the movement step is over, this instant has not been steered, and nothing
    collides (reading I-15). In that case every process under a law gets a new velocity, and a new
    spin if its law gives one (reading I-24). The next step begins. The time since the last update is what the step
    has used up (reading I-10). At last the due turns of processes that do not collide begin (rules Turn and
    Round). Where laws leave motions to chance, the new
    motions and all that follows wait until every process has drawn. *)

val ask : Semantics.t -> which:(int -> bool) -> State.t -> (State.t, Transition.fault) result
(** [ask c ~which s] is [s] with the laws evaluated of all steered processes whose index in [s] satisfies [which].
    Each of these waits to draw, or has the motion that its laws give. It is the part of {!settle} that evaluates
    laws. *)

val kicked : Semantics.t -> State.t -> State.t
(** [kicked c s] is [s] after all motions that {!ask} or draws gave have taken effect, but for the kicks that
    are blocked ({!Blocked.waiting}): the next movement step begins. No process of [s] waits to draw. It is the
    part of {!settle} that begins steps, before walkers stop. With {!Model.Wait}, it depends also on processes
    that are not steered. *)

val next_to_draw : Semantics.t -> State.t -> State.process option
(** The process that draws next: the first of {!drawers}, in linear time; [None] if no process waits to draw. *)

val drawers : Semantics.t -> State.t -> State.process list
(** All processes that wait to draw, in the order of {!Process.by_place}. They draw in this order, which no draw
    changes. *)

val chances : Semantics.t -> State.t -> State.process -> ((Given.t * Rat.t) list, Transition.fault) result
(** The motions that a waiting process may draw, each once and in order, with their probabilities. These are
    positive and sum to 1. They do not depend on what other processes have drawn. *)

val chances_in :
  'c Chances.t -> Semantics.t -> State.t -> State.process -> ((Given.t * 'c) list, Transition.fault) result
(** [chances_in n c s p] is {!chances} in other numbers. *)

val draw_label : State.process -> Given.t * Rat.t -> Transition.label
(** [draw_label p (given, chance)] is the label of the transition in which [p] draws the motion [given]. *)

val drawn : (State.process -> Given.t option) -> State.t -> State.t
(** [drawn given s] is [s] after each waiting process [p] for which [given p] is a motion has drawn it.
    It is the state before {!settle}. *)

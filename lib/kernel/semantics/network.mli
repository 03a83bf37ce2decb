(** The transition relation of networks (rule Successors). *)

open Scc_calculus

val initial : Semantics.t -> State.t -> (State.t, Transition.fault) result
(** The initial state from the declared one: split clocks set, the first steer done. *)

val successors : Semantics.t -> State.t -> (Transition.t list, Transition.fault) result
(** Every transition of a state, in a fixed order: what comes of the lots, while some are pending (rule
    Lot), the draws of who draws next, while somebody waits to draw (rule Draw), and else strong splits and
    closings, weak splits, each collision of the instant by itself (reading I-8), and time. A steer that falls
    due is part of the transition (reading I-15). *)

val wait : Semantics.t -> State.t -> Scc_exact.Rat.t -> (Transition.t option, Transition.fault) result
(** Rule Time by d, where bonds may be released at any time ({!Model.Any_time}) and time may pass: for 0 < d less
    than {!Time.delay}, or any d > 0 where that is [None]. {!successors} has the greatest alone. [None] for any
    other d. *)

val quiescent : Semantics.t -> State.t -> bool
(** No event can ever happen again (rule Quiescent). *)

(** {1 In parts}

    A split and a closing look at one process, and a collision at two. So what is possible in a network is what is
    possible for each process, for each two that meet, and for time. Who follows many states of a network that is
    not steered may remember the parts, and puts them together by these. *)

(** What may happen at once, by kinds: each with the last first, what single processes must do and their weak
    splits in the order of processes, collisions in that of pairs. *)
type 'a discrete = { urgent : 'a list; weak : 'a list; collisions : 'a list }

val is_urgent : 'a discrete -> bool
(** Whether no time passes before something happens. *)

val in_order : ('a -> 'b) -> 'a discrete -> time:(unit -> 'b list) -> 'b list
(** All of it in the order of {!successors}, and then time, which is not asked when something is urgent. *)

val urgent : Semantics.t -> State.process -> Transition.outcome list
(** What a process must do by itself, those of one label and result once: its strong splits ({!Splits.strong}),
    and then its closings ({!Closings.all}). *)

val weak : Semantics.t -> State.process -> Transition.outcome list
(** Likewise its weak splits. *)

val together : Semantics.t -> State.process array -> Transition.outcome list
(** What comes of the collisions of some processes, in the order of {!Collisions.clusters}: for networks that
    are not steered. What two do by themselves they do in any company, unless collisions are resolved together.
*)

val drawn :
  Semantics.t -> State.t -> before:(State.process -> Scc_exact.Vec.t option) -> State.process ->
  Scc_exact.Vec.t * Scc_exact.Rat.t -> (Transition.t, Transition.fault) result
(** The transition in which a process draws a velocity of a chance ({!Steer.chances}), of a state in which others
    have drawn before, each in its turn ({!Steer.drawers}), what the function says. *)

val draw_rules : Rule.t list
(** Those that a draw uses after which somebody still waits. *)

val time_rules : Semantics.t -> Rule.t list
(** Those that a passing of time uses. *)

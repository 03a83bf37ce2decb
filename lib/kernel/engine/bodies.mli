(** The processes of a run from event to event: where they are, what may happen to each of them now, and an agenda
    of what is to come. Times count from the start of the run. *)

open Scc_exact
open Scc_calculus
open Scc_semantics

type t

val start : Semantics.t -> step:State.step option -> State.t -> t
(** [start c ~step s] is the processes of [s], in the movement step [step]. The draws of [s] are left out. *)

(** {1 Time} *)

val now : t -> Rat.t
(** The time since the start. *)

val frame : t -> State.t
(** The present state without processes: its movement step and its absolute time. *)

val step : t -> State.step option
(** The present movement step of the network. *)

val set_step : t -> State.step option -> unit
(** Changes the present movement step of the network. *)

val come_up : t -> unit
(** Handles everything that the agenda has for this instant. It is to be called before {!splits}, {!find} and
    {!next_time}. *)

val next_time : t -> Rat.t option
(** The time of the next contact, horizon or split instant. It is [None] if there is none, and if bodies are
    steered and their movement step ends before. *)

val pass : t -> Rat.t -> unit
(** [pass t d] lets the time [d] pass, which goes no further than {!next_time}. *)

(** {1 What may happen now} *)

val splits : t -> (Transition.outcome list * Transition.outcome list) list
(** The urgent and the weak outcomes of single processes ({!Network.urgent}, {!Network.weak}), for all processes
    that have any, in order. *)

val find : t -> (State.process -> State.process -> Transition.outcome Colliding.found) -> unit
(** [find t found] finds what may come of the pairs that meet now. [found p q] is this for two processes. It is
    called once for each pair that meets, and again after a change of one of the two. *)

val collisions : t -> int * (int -> Transition.outcome)
(** The number of collisions that are possible now, and each by its number from 0 on, in the order of pairs, as
    {!find} found them last. *)

val stopping : t -> State.process list
(** The walkers that are to stop now, in order, as {!find} found them last (rule Blocked). *)

val involved : t -> State.process list
(** All processes that touch and approach another one, in order, and perhaps others. *)

val pending : t -> State.process list
(** All processes at which lots are pending now (rule Lot), in order. *)

(** {1 Processes} *)

val steered : t -> State.process list
(** The steered processes as they are now, in order. It takes time proportional to the size of the network. *)

val unsteered : t -> State.process list
(** The other processes as they are now, in order. It takes time proportional to the size of the network. *)

val with_leaves : t -> int list -> State.process list
(** [with_leaves t leaves] is the processes that have some of these leaves as they are now, in order, apart from
    draws. It takes time proportional to the number of [leaves], and not to the size of the network. *)

val any_steered : t -> bool
(** [any_steered t] is true if some process is steered. *)

val velocity : t -> int -> Vec.t
(** The velocity of the process with this first leaf. It is a bug if no process begins with the leaf. *)

val change : t -> Transition.outcome -> unit
(** Replaces the processes that are gone in an outcome by those that come. *)

val decide : t -> State.process -> unit
(** [decide t p] gives a process the lots of [p], which differs from it in these alone. *)

val turn : t -> State.process list -> unit
(** [turn t processes] gives each of [processes] its velocity. They are otherwise as they are in [t] now. *)

(** Changes of processes, as in {!Event_run.changes}. *)
type changes = { gone : int list; come : State.process list }

val changes : t -> changes
(** The changes since the last call of this function, or since the start. *)

val work : t -> Flights.work
(** The work of the broad phase since the start. *)

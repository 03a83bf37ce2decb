(** The events that a model allows at the point where a recorded trace diverges, now or after some passing of
    time. *)

open Scc_exact
open Scc_calculus
open Scc_semantics

(** An event that is possible. *)
type t = {
  at : State.t;  (** the state in which it is possible *)
  time : Rat.t;
  taken : Transition.t;
  from : Trace_search.hypothesis;  (** the hypothesis from which that state is reached *)
}

val is_urgent : t -> bool
(** [is_urgent t] is true if no time passes before the event: {!Scc_semantics.Transition.is_urgent}. *)

val find : Against.t -> observed:(Transition.label -> bool) -> past:Rat.t -> Trace_search.dead_end -> t list
(** The observed events that were possible since the last item was met, and those of later instants, each once,
    in order of time. The search ends at the first instant after [past] that has any. *)

val at_first_instant : Against.t -> observed:(Transition.label -> bool) -> Trace_search.hypothesis -> t list
(** The observed events of the first instant, from the hypothesis on, that has any. *)

(** The events that a model allows where a recorded trace is none of it, now or after some passing of time. *)

open Scc_exact
open Scc_calculus
open Scc_semantics

type t = {
  at : State.t;  (** where it is possible *)
  time : Rat.t;
  taken : Transition.t;
  from : Search.hypothesis;  (** that it is reached from *)
}

val is_urgent : t -> bool
(** A collision or a strong split: no time passes before it. *)

val find : Against.t -> observed:(Transition.label -> bool) -> past:Rat.t -> Search.dead_end -> t list
(** Observed events that were possible since the last item was met, and those of the instants after that, up to the
    first after a time at which there are any; each once, in order of time. *)

val at_first_instant : Against.t -> observed:(Transition.label -> bool) -> Search.hypothesis -> t list
(** The events of the first instant from the hypothesis on at which there are any. *)

(** One run as a timed graph, a chain, on which formulas are evaluated by the same rules as everywhere.

    Of a run only what is still open is kept: the last few states, as truths of predicates. What came before them
    is in the bounds of time that are left of each formula, and in numbers of events. Where a predicate is
    undecided, the truths of all states from there on are kept, since a later state may decide the formula. *)

open Scc_exact
open Scc_calculus
open Scc_semantics
open Scc_engine

(** {1 Questions} *)

(** The formulas of some properties, prepared for many runs. *)
type questions

val questions : Semantics.t -> Path.t list -> questions
(** Prepares the formulas of these paths. *)

(** The answer of a run. *)
type answer =
  | Truth of bool
  | Number of Rat.t
  | Never  (** the run never reaches the event on which the number depends *)
  | Open  (** not known as yet *)
  | No_value of string  (** the number has no value there, and why *)

(** {1 Runs} *)

(** A run so far. *)
type t

val start : questions -> State.t -> t
(** A run with its initial state alone. *)

val passing : t -> lasts:Rat.t -> (unit -> State.t) -> unit
(** [passing t ~lasts state] says that so much time is about to pass from the last state. The state is computed if
    a number is asked for at an instant in between. {!step} or {!pass} tells that it has passed. *)

val step : t -> Run.alternative -> state:(unit -> State.t) -> part:(int list -> State.t) -> unit
(** Adds the state after a transition, in full or as the processes with some leaves. Only what the questions depend
    on is computed. *)

val pass : t -> Rat.t -> State.t -> unit
(** [pass t d s] adds the state [s] within a passing of time, [d] after the last one. *)

val for_ever : t -> (unit -> State.t) option -> unit
(** Ends the chain: from the last state on, time passes without end. That state is given unless {!pass} added it.
*)

val dead_end : t -> (unit -> State.t) option -> unit
(** Ends the chain: nothing can happen in the last state, not even the passing of time (rule DeadEnd). *)

val is_over : t -> bool
(** [is_over t] is true if the chain has ended. *)

val length : t -> int
(** The number of states. *)

(** {1 Answers}

    The continuation of a chain that has not ended is unknown. An answer that is not {!Open} is final. *)

val look : t -> unit
(** Looks for answers in all states so far. {!step} and {!pass} do so every few states. *)

val settled : t -> bool
(** [settled t] is true if no question was open at the last look. *)

val answers : t -> answer list
(** The answer to each question at the last look. *)

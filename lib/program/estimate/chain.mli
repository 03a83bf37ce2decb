(** One run as a timed graph, a chain, on which formulas are evaluated by the same rules as everywhere. *)

open Scc_exact
open Scc_calculus
open Scc_semantics

(** A run so far. *)
type t

val make : Semantics.t -> t
(** A chain without any state. *)

val start : t -> State.t -> unit
(** Adds the initial state. *)

val step : t -> Transition.label -> State.t -> unit
(** Adds the state after a transition. *)

val for_ever : t -> unit
(** Ends the chain: from the last state on, time passes without end. *)

val dead_end : t -> unit
(** Ends the chain: nothing can happen in the last state, not even the passing of time (rule DeadEnd). *)

val is_over : t -> bool
(** [is_over t] is true if the chain has ended. *)

val length : t -> int
(** The number of states. *)

(** {1 Formulas}

    The continuation of a chain that has not ended is unknown. *)

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

val answers : questions -> t -> answer list
(** The answer to each question on the run so far. *)

(** One run as a timed graph, on which formulas are judged by the rules for all others: a chain. *)

open Scc_exact
open Scc_calculus
open Scc_semantics

type t

val make : Semantics.t -> t
(** Without any state. *)

val start : t -> State.t -> unit
val step : t -> Transition.label -> State.t -> unit

val for_ever : t -> unit
(** From the last state on time passes without end. *)

val dead_end : t -> unit
(** In the last state nothing can go on, not even time (rule DeadEnd). *)

val is_over : t -> bool
(** Nothing comes after the last state. *)

val length : t -> int

(** {1 Formulas}

    What comes after the last state is not known. *)

type questions

val questions : Semantics.t -> Path.t list -> questions

(** What a run says. *)
type answer =
  | Truth of bool
  | Number of Rat.t
  | Never  (** it never comes to where the number would be known *)
  | Open  (** not known as yet *)
  | No_value of string  (** the number has no value there, and why *)

val answers : questions -> t -> answer list
(** Of each question, on the run so far. *)

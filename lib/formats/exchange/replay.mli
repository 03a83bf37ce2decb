(** One run of a model, led by choices. *)

open Scc_base
open Scc_exact
open Scc_calculus
open Scc_semantics
open Scc_engine

type policy =
  | First  (** the first successor, always *)
  | Random of int64  (** each successor equally likely, by {!Splitmix64} from this seed *)
  | Scheduled of Schedule.t

type limits = {
  steps : int option;  (** at most so many transitions *)
  time : Rat.t option;  (** model time *)
  instant : int;  (** at most so many transitions in a row without time passing (Zeno guard) *)
}

val default_instant : int
(** 10 000. *)

val default_steps : int
(** Of a run that nothing else ends: 1 000. *)

(** Why and where the model was given up. *)
type given_up = { fault : Transition.fault; steps : int;  (** transitions before it *) time : Rat.t }

val diagnostic : Model.t -> given_up -> Diag.t
(** Of the fault, with a note that says where. *)

(** How the run stands where it was left. *)
type ending =
  | Open  (** there is more to come *)
  | Quiescent  (** nothing will ever happen again *)
  | Stuck of given_up  (** neither time nor anything else can go on (rule DeadEnd) *)
  | Zeno  (** the Zeno guard stopped it *)

(** Whole states cost more than the transitions of a large network: they are made on demand, and may only be asked
    for while the event is emitted. *)
type event =
  | Start of State.t
  | Step of {
      number : int;  (** from 1 *)
      index : int;
      (** of a passing of time that is less than the greatest one, its; where time may pass for ever, the number
          after all others *)
      among : int;
      time : Rat.t;  (** model time after it *)
      taken : Run.alternative;
      changes : unit -> Event_run.changes option;
      (** {!Run.changes} since it was asked for last. A run that is followed by them is asked after each step. *)
      state : unit -> State.t;  (** after it *)
    }
  | Instant of { offset : Rat.t; time : Rat.t; state : State.t }
  (** the run is left in the midst of a passing of time, [offset] after the last transition *)
  | End of {
      steps : int;
      time : Rat.t;
      ending : ending;
      last : (unit -> State.t) option;  (** the state there, unless an [Instant] told it *)
      rounded : (Totals.t * Totals.t) option;
      (** bounds on what rule Round has added, where anything is rounded *)
    }

type failure =
  | Fault of given_up  (** SC0601: the transitions of the present state cannot be computed *)
  | Refused of Diag.t  (** SC0802: the schedule does not fit here; the note tells what was possible *)
  | Interrupted

val run :
  ?passing:(start:Rat.t -> lasts:Rat.t -> (unit -> State.t) -> unit) ->
  ?attempt:Scc_graph_search.Limits.attempt ->
  Semantics.t ->
  State.t ->
  policy ->
  limits ->
  interrupted:(unit -> bool) ->
  (event -> unit) ->
  (ending, failure) result
(** [run semantics declared policy limits ~interrupted emit] emits the events of the run in order. The events
    depend on the model and the choices alone, not on where the choices came from. When the limit of time
    falls within a passing of time, the run ends with an [Instant] at the limit. [passing] is told of each stretch
    of time before it passes: when it begins, how long it lasts, and the state there, which may only be asked for
    then. A step that [attempt] gives up is an interruption. A dead end is an end, and no failure. *)

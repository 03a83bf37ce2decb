(** One run of a model, directed by choices. *)

open Scc_base
open Scc_exact
open Scc_calculus
open Scc_semantics
open Scc_engine

(** How the next transition is chosen. *)
type policy =
  | First  (** the first successor, always *)
  | Random of int64  (** each successor equally likely, by {!Splitmix64} from this seed *)
  | Scheduled of Schedule.t

(** Where a run ends. *)
type limits = {
  steps : int option;  (** at most so many transitions *)
  time : Rat.t option;  (** model time *)
  instant : int;
  (** at most so many transitions in a row without time passing, not counting draws (Zeno guard) *)
}

val default_instant : int
(** The default of [limits.instant]: 10 000. *)

val default_steps : int
(** The number of steps after which a run ends that has no other limit: 1 000. *)

(** The reason why the model was given up, and the place. *)
type given_up = { fault : Transition.fault; steps : int;  (** transitions before it *) time : Rat.t }

val diagnostic : Model.t -> given_up -> Diag.t
(** The diagnostic of the fault, with a note on the place. *)

(** The end of a run. *)
type ending =
  | Open  (** it could go on *)
  | Quiescent  (** nothing will ever happen again *)
  | Stuck of given_up  (** neither time nor anything else can go on (rule DeadEnd) *)
  | Zeno  (** the Zeno guard stopped it *)
  | Broken_off  (** it was interrupted, and {!run} returns [Interrupted] *)

(** An event of a run. Whole states cost more than the transitions of a large network, so they are computed on
    demand. The functions may only be called while the event is emitted. *)
type event =
  | Start of State.t
  | Step of {
      number : int;  (** from 1 *)
      index : int;
      (** its number among the successors. A passing of time below the greatest one has its number, and if
          time may pass for ever, the number after all others *)
      among : int;
      free : bool;  (** it was one of several choices, where all that chance decides is one choice *)
      time : Rat.t;  (** model time after it *)
      taken : Run.alternative;
      changes : unit -> Event_run.changes option;
      (** [Run.changes] since its last call. To follow a run by its changes, call it after each step. *)
      state : unit -> State.t;  (** after it *)
      part : int list -> State.t;  (** of this state, the processes that have some of these leaves *)
      draws_on : bool;  (** it is a draw or a lot, and another one follows at this instant *)
    }
  | Instant of { offset : Rat.t; time : Rat.t; state : State.t }
  (** the run ends within a passing of time, [offset] after the last transition *)
  | End of {
      steps : int;
      time : Rat.t;
      ending : ending;
      last : (unit -> State.t) option;  (** the state there, unless an [Instant] contains it *)
      rounded : (Totals.t * Totals.t) option;
      (** bounds on the totals that rule Round has added, if anything is rounded *)
    }

(** Why a run could not be made. *)
type failure =
  | Fault of given_up  (** SC0601: the transitions of the present state cannot be computed *)
  | Refused of Diag.t  (** SC0802: the schedule does not fit here; the note lists what was possible *)
  | Interrupted of Scc_graph_search.Limits.stop

val run :
  ?passing:(start:Rat.t -> lasts:Rat.t -> (unit -> State.t) -> unit) ->
  ?attempt:Scc_graph_search.Limits.attempt ->
  ?joint:bool ->
  Semantics.t ->
  State.t ->
  policy ->
  limits ->
  interrupted:(unit -> bool) ->
  (event -> unit) ->
  (ending, failure) result
(** [run semantics declared policy limits ~interrupted emit] emits the events of the run in order. They depend
    on the model and the choices alone, not on the source of the choices. If the limit of time falls within a
    passing of time, the run ends with an [Instant] at the limit.

    [passing] is called before each stretch of time passes, with its start, its duration and the state there,
    which may only be computed then. With [joint] (false by default) [limits.steps] counts the draws and lots of
    one instant as one transition. A step that [attempt] gives up is an interruption. A dead end is an end,
    and no failure. *)

(** {1 Choices} *)

val at_random : Run.labels -> Splitmix64.t -> int * Splitmix64.t
(** The number of a transition that {!Random} would take, and the generator after that. There is at least one. *)

val is_free : Run.labels -> int -> bool
(** [is_free labels i] is true if the transition with the number [i] is one of several choices, and chance does not
    decide between all of them. *)

(** One exploration that decides some properties, over the whole continuous run (rules Instants, Verdict, Zeno). *)

open Scc_exact
open Scc_calculus
open Scc_semantics
open Scc_property
open Scc_graph_search
open Scc_state_space
open Scc_explain

type options = {
  bounds : Bounds.t;
  reductions : Reduction.kind list;
  compact : int option;
  (** hash compaction with room for so many states, for searches without a bound of time *)
  order : State_graph.order;
  (** of the exploration: with [By_steps] runs that decide a search have as few steps as possible, with
      [By_time] they end as early as possible *)
  surroundings : Limits.surroundings;
  observe : (State.t -> unit) option;  (** called with each new state, in order *)
  prove : bool;
  (** an invariant is searched for before anything is explored, in half of the time (rule Invariants).
      Otherwise, over zones, one is searched for only where exploration leaves a check open. *)
  expanding : about:string -> State_graph.expanding;
  compacting : about:string -> State_fingerprints.expanding;
  (** the way of expanding with hash compaction. Both functions are called for each exploration. Its checks
      ({!about}) and the options determine it. Explorations with equal checks come in the same order. *)
}

val default : options
(** Default bounds, all reductions, by steps, in quiet surroundings. *)

type stats = {
  states : int;
  transitions : int;
  depth : int;  (** the greatest of the states' least depths *)
  model_time : Rat.t option;  (** the greatest of the states' earliest arrivals; over zones there is none *)
  complete : bool;  (** every state was expanded *)
  eventful : bool;  (** some transition is not a passing of time *)
  decided_early : bool;  (** the exploration ended because every property was decided *)
  split_step : Rat.t option;  (** a weak split was enabled in a state: {!Network_lts.split_step} *)
  stopped_by : Verdict.truncation list;  (** the bounds that left states unexpanded *)
  faults : Scc_base.Diag.t list;  (** the reasons why transitions of states could not be computed, each text
                                      once *)
  dead_ends : Scc_base.Diag.t list;  (** the reasons why runs end in states without transitions, as warnings
                                         (rule Run) *)
  converges : Verdict.convergence option;  (** what event times did before a bound ended it *)
  growth : Scc_base.Diag.t option;  (** a number that was too long (SC0705) *)
  shared : Scc_base.Diag.t option;  (** a bond on an edge that open faces share (SC0706) *)
  causes : Growth.cause list;  (** what is likely to keep it from closing *)
  left_out : Verdict.truncation option;  (** what ended the search for such, before all was looked at *)
}

type result = {
  outcomes : (Property.check * Verdict.t * Lost.taken) list;
  (** in the order given, with what kept a run from being shown (as {!Verdict.outcome}) *)
  stats : stats;
  zeno : Witness.t option;
  (** a reachable cycle in which no time passes, or a run that met the [instant] guard *)
  lost : Lost.taken;  (** why the Zeno run is missing, if it is *)
  stores : (string * int) list;  (** the memory of the explored graph: states, labels and edges, in bytes *)
  numbers : unit -> (string * int) list;  (** the lengths of the longest numbers: {!Catalogue.longest} *)
}

val horizon : Property.check list -> Rat.t option
(** The time beyond which no property looks; [None] if one looks at all times, or if there are no
    properties. *)

val about : Property.check list -> string
(** A text that identifies an exploration for some checks: their names and formulas. *)

val system : options -> Semantics.t -> initial:State.t -> Property.check list -> Plan.t list -> Network_lts.context
(** The system to explore for some checks, with their plans and the reductions that preserve them. *)

val plan : Property.check -> Plan.t
(** The plan of a check; a question for numbers has the plan of its formula as a whole. *)

val questions : Network_lts.context -> Plan.t -> Search.question list
(** The questions of the searches of a plan, in their order. *)

val check : options -> Semantics.t -> initial:State.t -> Property.check list -> result
(** The result of one exploration for all checks. The initial state is {!Scc_semantics.Network.initial} of the
    declared state. Witnesses are replayed before they are returned. *)

val may_have_events : options -> Semantics.t -> initial:State.t -> bool
(** [may_have_events options m ~initial] is false if it is known, from at most 5 000 states, that no event ever
    happens. *)

val explore :
  ?time_seen:Time_seen.t -> ?visitor:(Network_lts.context -> State_graph.visitor) ->
  options -> Semantics.t -> initial:State.t ->
  Network_lts.context * State_graph.t * stats
(** The exploration alone, with its statistics. [time_seen] is that of {!Network_lts.make}; the functions of
    [visitor] are called while states are found. *)

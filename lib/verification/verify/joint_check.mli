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
  (** of the exploration: with [By_steps] runs that decide a search are as short as can be, with [By_time] as
      early *)
  surroundings : Limits.surroundings;
  observe : (State.t -> unit) option;  (** called with each new state, in order *)
  prove : bool;
  (** over zones, an invariant is looked for before anything is explored, and not only where nothing else proves it
      (rule Invariants), in half of the time *)
  expanding : about:string -> State_graph.expanding;
  compacting : about:string -> State_fingerprints.expanding;
  (** the same with hash compaction: asked for with each exploration; what it is about and the options determine
      it, and explorations that are about the same come in the same order *)
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
  faults : Scc_base.Diag.t list;  (** why transitions of states could not be computed, each text once *)
  dead_ends : Scc_base.Diag.t list;  (** why runs end in states without transitions, as warnings (rule Run) *)
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
  lost : Lost.taken;  (** what kept that from being shown *)
  stores : (string * int) list;  (** what the explored graph takes: states, labels and edges, in bytes *)
  numbers : unit -> (string * int) list;  (** how far numbers have grown: {!Catalogue.longest} *)
}

val horizon : Property.check list -> Rat.t option
(** The time beyond which none of the properties looks; [None]: one looks at all times. *)

val about : Property.check list -> string
(** What an exploration for some checks is about. *)

val system : options -> Semantics.t -> initial:State.t -> Property.check list -> Plan.t list -> Network_lts.context
(** The system to explore for some checks, of which these are the plans, with the reductions that keep them. *)

val plan : Property.check -> Plan.t

val questions : Network_lts.context -> Plan.t -> Search.question list
(** What is searched for, in the order of the searches of the plan. *)

val check : options -> Semantics.t -> initial:State.t -> Property.check list -> result
(** [initial] is the initial state ({!Scc_semantics.Network.initial} of what was declared). Witnesses are
    replayed before they are returned. *)

val may_have_events : options -> Semantics.t -> initial:State.t -> bool
(** False when it is known, after a look at no more than some thousands of states, that nothing ever happens. *)

val explore :
  ?time_seen:Time_seen.t -> ?visitor:(Network_lts.context -> State_graph.visitor) ->
  options -> Semantics.t -> initial:State.t ->
  Network_lts.context * State_graph.t * stats
(** The exploration alone; [time_seen] is that of {!Network_lts.make}, and [visitor] is told what is found. *)

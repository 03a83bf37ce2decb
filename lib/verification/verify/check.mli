(** Checking the properties of a model. *)

open Scc_exact
open Scc_calculus
open Scc_semantics
open Scc_property
open Scc_graph_search
open Scc_state_space
open Scc_explain

type options = Joint_check.options = {
  bounds : Bounds.t;
  reductions : Reduction.kind list;
  compact : int option;
  order : State_graph.order;
  surroundings : Limits.surroundings;
  observe : (State.t -> unit) option;
  prove : bool;
  expanding : about:string -> State_graph.expanding;
  compacting : about:string -> State_fingerprints.expanding;
}

val default : options

type stats = Joint_check.stats = {
  states : int;
  transitions : int;
  depth : int;
  model_time : Rat.t option;
  complete : bool;
  eventful : bool;
  decided_early : bool;
  split_step : Rat.t option;
  stopped_by : Verdict.truncation list;
  faults : Scc_base.Diag.t list;
  dead_ends : Scc_base.Diag.t list;
  converges : Verdict.convergence option;  (** what event times did before a bound ended it *)
  growth : Scc_base.Diag.t option;  (** a number that was too long (SC0705) *)
  shared : Scc_base.Diag.t option;  (** a bond on an edge that open faces share (SC0706) *)
  causes : Growth.cause list;  (** what is likely to keep it from closing *)
  left_out : Verdict.truncation option;  (** what ended the search for such, before all was looked at *)
}
(** Of several explorations: sums, and the greatest depth and time. *)

(** An exploration of a part of the network, which does for some of the properties (rule Slice). *)
type slice = {
  properties : string list;  (** their names *)
  left_out : string list;  (** leaves, in order *)
  explored : stats;
}

type report = {
  outcomes : Verdict.outcome list;  (** in the order given *)
  stats : stats;
  uneventful : bool;  (** it is known that nothing ever happens in the whole network *)
  slices : slice list;  (** of all the explorations, those that left something out *)
  zeno : Witness.t option;
  (** a reachable cycle in which no time passes, or a run that met the [instant] guard *)
  lost : string list;  (** faults of scc, by which that could not be rebuilt (as {!Verdict.outcome}) *)
  left_out : Verdict.truncation option;  (** what ended the making of that *)
  stores : (string * int) list;  (** what the explored graphs take, by name, in bytes *)
  where : Scc_regions.Where.t list;
  (** of an exploration over zones: for which values of the parameters each property holds, as far as was asked *)
  invariants : Zone_proof.end_ list;  (** likewise, what was looked for to prove them (rule Invariants) *)
  numbers : unit -> (string * int) list;  (** how far numbers have grown: {!Catalogue.longest} *)
}

val faults : report -> string list
(** All faults of scc that are told in it, each once. A report with any has all but the runs that they are about,
    and is to end with exit code 70. *)

val run : options -> Semantics.t -> initial:State.t -> Property.check list -> report
(** One exploration serves all properties that need the same: those that do with a part of the network (rule
    Slice), and those that see no time, or time up to a constant (rule AbsoluteTime), are explored apart from
    others. [initial] is the initial state ({!Scc_semantics.Network.initial} of what was declared). Witnesses are
    replayed before they are returned, and are runs of the whole network. *)

(** What {!run} explores for some of the properties, for whoever explores by other means. *)
type exploration = {
  semantics : Semantics.t;
  start : State.t;  (** the initial state, or the part of it that does *)
  members : Property.check list;
  left_out : string list;  (** leaves, in order *)
  lift : Witness.t -> Witness.t option;
  (** the run as one of the whole network; [None] of one that goes on later than anything is asked about *)
}

val explorations : options -> Semantics.t -> initial:State.t -> Property.check list -> exploration list
(** In the order of {!run}, without hash compaction. *)

val add : stats -> stats -> stats
(** Of two explorations together. *)

val unexplored : options -> Scc_property.Property.check list -> Scc_graph_search.Limits.stop -> report
(** What is told where nothing came of an exploration before it had to end. *)

val run_without :
  options -> Semantics.t -> initial:State.t -> Scc_property.Property.check list ->
  decided:(Scc_property.Property.check -> Verdict.outcome option) -> report
(** {!run} for those that are not decided in another way already; nothing is explored if all are. *)

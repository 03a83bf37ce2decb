(** Checking the properties of a model. *)

open Scc_calculus
open Scc_semantics
open Scc_property
open Scc_explain

(** An exploration of a part of the network that decides some of the properties (rule Slice). *)
type slice = {
  properties : string list;  (** their names *)
  left_out : string list;  (** leaves, in order *)
  explored : Stats.t;
}

type report = {
  outcomes : Verdict.outcome list;  (** in the order given *)
  stats : Stats.t;
  uneventful : bool;  (** it is known that nothing ever happens in the whole network *)
  slices : slice list;  (** of all the explorations, those that left something out *)
  zeno : Witness.t option;
  (** a reachable cycle in which no time passes, or a run that met the [instant] guard *)
  lost : string list;  (** faults of scc, by which that could not be rebuilt (as {!Verdict.outcome}) *)
  left_out : Verdict.truncation option;  (** the bound that ended making the Zeno run *)
  stores : (string * int) list;  (** the memory of the explored graphs, by name, in bytes *)
  where : Scc_regions.Where.t list;
  (** of an exploration over zones: the values of the parameters for which each property holds, as far as
      requested *)
  invariants : By_invariant.end_ list;  (** of an exploration over zones: the results of the searches for
                                            invariants that prove them (rule Invariants) *)
  numbers : unit -> (string * int) list;  (** the lengths of the longest numbers: [Catalogue.longest] *)
}

val faults : report -> string list
(** All faults of scc in the report, each once. A report with any of them lacks only the runs that they
    concern; the command ends with exit code 70. *)

val run : Setup.t -> Semantics.t -> initial:State.t -> Property.check list -> report
(** [run options m ~initial checks] checks the properties. One exploration serves all properties with the same
    needs. Separate explorations are made for those that a part of the network decides (rule Slice), and for
    those that see no time, or time up to a constant (rule AbsoluteTime). The initial state is
    {!Scc_semantics.Network.initial} of the declared state. Witnesses are replayed before they are returned,
    and are runs of the whole network. *)

(** An exploration of {!run} for some of the properties, for other ways of exploring. *)
type exploration = {
  semantics : Semantics.t;
  start : State.t;  (** the initial state, or the part of it that is enough *)
  members : Property.check list;
  left_out : string list;  (** leaves, in order *)
  lift : Witness.t -> Witness.t option;
  (** the run as one of the whole network; [None] for a run that goes on beyond the horizon of the
      properties *)
}

val explorations : Setup.t -> Semantics.t -> initial:State.t -> Property.check list -> exploration list
(** The explorations in the order of {!run}, without hash compaction. *)

val unexplored : Setup.t -> Scc_property.Property.check list -> Scc_graph_search.Limits.stop -> report
(** The report if the exploration was stopped before it had any result: all checks are undecided. *)

val run_without :
  Setup.t -> Semantics.t -> initial:State.t -> Scc_property.Property.check list ->
  decided:(Scc_property.Property.check -> Verdict.outcome option) -> report
(** [run_without options m ~initial checks ~decided] is the report of {!run}, where checks with an outcome in
    [decided] are not explored. Nothing is explored if all have one. *)

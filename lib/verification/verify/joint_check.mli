(** One exploration that decides some properties, over the whole continuous run (rules Instants, Verdict, Zeno). *)

open Scc_exact
open Scc_calculus
open Scc_semantics
open Scc_property
open Scc_state_space
open Scc_explain

type result = {
  outcomes : (Property.check * Verdict.t * Lost.taken) list;
  (** in the order given, with what kept a run from being shown (as {!Verdict.outcome}) *)
  stats : Stats.t;
  zeno : Witness.t option;
  (** a reachable cycle in which no time passes, or a run that met the [instant] guard *)
  lost : Lost.taken;  (** why the Zeno run is missing, if it is *)
  stores : (string * int) list;  (** the memory of the explored graph: states, labels and edges, in bytes *)
  numbers : unit -> (string * int) list;  (** the lengths of the longest numbers: [Catalogue.longest] *)
}

val horizon : Property.check list -> Rat.t option
(** The time beyond which no property looks; [None] if one looks at all times, or if there are no
    properties. *)

val about : Property.check list -> string
(** A text that identifies an exploration for some checks: their names and formulas. *)

val system : Setup.t -> Semantics.t -> initial:State.t -> Property.check list -> Plan.t list -> Network_lts.context
(** The system to explore for some checks, with their plans and the reductions that preserve them. *)

val plan : Property.check -> Plan.t
(** The plan of a check; a question for numbers has the plan of its formula as a whole. *)

val check : Setup.t -> Semantics.t -> initial:State.t -> Property.check list -> result
(** The result of one exploration for all checks. The initial state is {!Scc_semantics.Network.initial} of the
    declared state. Witnesses are replayed before they are returned. *)

val may_have_events : Setup.t -> Semantics.t -> initial:State.t -> bool
(** [may_have_events options m ~initial] is false if it is known, from at most 5 000 states, that no event ever
    happens. *)

val explore :
  ?time_seen:Time_seen.t -> ?visitor:(Network_lts.context -> State_graph.visitor) ->
  Setup.t -> Semantics.t -> initial:State.t ->
  Network_lts.context * State_graph.t * Stats.t
(** The exploration alone, with its statistics. [time_seen] is that of [Network_lts.make]; the functions of
    [visitor] are called while states are found. *)

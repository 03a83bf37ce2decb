(** The resources that a command takes: seconds of the clock by phase, and memory. They vary from run to run. *)

(** The phases so far. *)
type t

val start : ?clock:(unit -> float) -> unit -> t
(** No phases yet. [clock] gives seconds (default: the time of day). *)

val phase : t -> string -> (unit -> 'a) -> 'a
(** Calls a function, and adds its time to the phase of this name, without the time of phases within it. *)

val booking : t -> Scc_graph_search.Limits.attempt -> Scc_graph_search.Limits.attempt
(** Attempts with their time added to the phases [prove] (search for an invariant) and [conclude]
    (everything after the exploration). *)

val seconds : t -> (string * float) list
(** The seconds of each phase, in the order in which the phases began. *)

val lines : t -> Scc_verify.Check.report -> string list
(** The measurements as lines of text. *)

val numbers : t -> Scc_verify.Check.report -> Scc_reports.Measured_json.t
(** The measurements of a report, for JSON. *)

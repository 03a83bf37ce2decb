(** What a command takes: seconds of the clock by phase, and memory. It varies from run to run. *)

type t

val start : ?clock:(unit -> float) -> unit -> t
(** [clock] tells seconds, those of the day if nothing is said. *)

val phase : t -> string -> (unit -> 'a) -> 'a
(** Adds the time that the function takes to the phase of this name, without that of phases within it. *)

val booking : t -> Scc_graph_search.Limits.attempt -> Scc_graph_search.Limits.attempt
(** What looks for a proof, and what concludes, are phases of their own, [prove] and [conclude]. *)

val seconds : t -> (string * float) list
(** Of each phase, in the order in which they were begun. *)

val lines : t -> Scc_verify.Check.report -> string list
(** For a person. *)

val json : t -> Scc_verify.Check.report -> Scc_exchange.Json.t
(** [measured] of [specs/schema/check.schema.json]. *)

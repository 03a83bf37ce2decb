(** What a command takes: seconds of the clock by phase, and memory. It varies from run to run. *)

type t

val start : unit -> t

val phase : t -> string -> (unit -> 'a) -> 'a
(** Adds the time that the function takes to the phase of this name. *)

val lines : t -> Scc_verify.Check.report -> string list
(** For a person. *)

val json : t -> Scc_verify.Check.report -> Scc_exchange.Json.t
(** [measured] of [specs/schema/check.schema.json]. *)

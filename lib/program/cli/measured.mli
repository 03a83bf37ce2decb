(** The resources that a command takes: seconds of the clock by phase, and memory. They vary from run to run. *)

(** The phases so far. *)
type t

val start : unit -> t
(** No phases yet. *)

val phase : t -> string -> (unit -> 'a) -> 'a
(** Calls a function, and adds its time to the phase of this name. *)

val lines : t -> Scc_verify.Check.report -> string list
(** The measurements as lines of text. *)

val json : t -> Scc_verify.Check.report -> Scc_exchange.Json.t
(** The member [measured] of [specs/schema/check.schema.json]. *)

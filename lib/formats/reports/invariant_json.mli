(** Invariants, as the member [invariants] of the document of [scc check] (schema check.schema.json). *)

open Scc_json

val format : (Scc_calculus.Model.t * Scc_verify.By_invariant.end_, unit) Json_format.t
(** The format of an invariant: its kinds of states, or the reason why none was found. Each kind has its processes,
    the events that have just happened, and constraints on its numbers ({!Scc_certificate.Invariant.name}). *)

(** Invariants, as the member [invariants] of the document of [scc check] (schema check.schema.json). *)

val found : Scc_calculus.Model.t -> Scc_verify.Zone_proof.end_ -> Json.t
(** An invariant as its kinds of states, or the reason why none was found. Each kind has its processes, the
    events that have just happened, and constraints on its numbers ({!Scc_certificate.Invariant.name}). *)

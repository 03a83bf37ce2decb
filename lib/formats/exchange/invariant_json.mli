(** Invariants, as [invariants] of the document of [scc check]: schema check.schema.json. *)

val found : Scc_calculus.Model.t -> Scc_verify.Zone_proof.end_ -> Json.t
(** Its kinds of states, each with its processes, the events that have just happened, and constraints on its
    numbers ({!Scc_symbolic.Invariant.name}); or why none was found. *)

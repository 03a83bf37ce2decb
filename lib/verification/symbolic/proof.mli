(** The consequences of an invariant (rule Invariants): predicates that never hold. *)

open Scc_polyhedra
open Scc_property
open Scc_state_sets

type t = {
  sets : Answers.sets;  (** the values for which a check surely holds, and those for which it surely fails *)
  claims : Scc_certificate.Invariant.claim list;  (** the claims on which [sets] rest *)
}

val may_prove : Property.temporal -> bool
(** [may_prove formula] is false if no invariant proves that the formula holds, nor that it fails. *)

val views : Instant.context -> Scc_certificate.Invariant.t -> Zone_graph.node list
(** All states of an invariant, and all states that pass by from them, as nodes for {!make}. *)

val make :
  Instant.context -> Atoms.context -> parameters:Polyhedron.t -> Zone_graph.node list -> Property.temporal -> t
(** [make c atoms ~parameters views formula] is what the invariant proves of a formula. Only parts with
    [always] and [possibly], with or without bounds of time, are proved. Predicates with model time or
    [quiescent] are not proved, since the larger set of states determines neither. *)

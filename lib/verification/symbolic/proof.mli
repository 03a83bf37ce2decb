(** What an invariant proves (rule Invariants): that something never comes. *)

open Scc_polyhedra
open Scc_property

type claim = { never : Property.prop; values : Union.t }
(** For these values of the parameters no state of any run satisfies the predicate. *)

type t = {
  sets : Answers.sets;  (** where a check holds, and where it does not, for sure *)
  claims : claim list;  (** that this rests on *)
}

val views : Instant.context -> Invariant.t -> Zone_graph.node list
(** All states of an invariant, and all that pass by from them. *)

val make :
  Instant.context -> Atoms.context -> parameters:Polyhedron.t -> Zone_graph.node list -> Property.temporal -> t
(** Of a check that is made of [always] and [possibly], with or without bounds of time; of others nothing. Nor of
    predicates that speak of model time, or ask for rest ([quiescent]): a larger set of states knows neither. *)

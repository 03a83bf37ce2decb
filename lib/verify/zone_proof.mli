(** Verdicts by invariants (rule Invariants): an invariant is looked for, what it proves of some checks is found,
    and all of this is checked afresh ({!Scc_certificate.Certificate}) before it counts. *)

open Scc_calculus
open Scc_semantics
open Scc_property
open Scc_symbolic

type t = {
  invariant : Invariant.t;
  proofs : Proof.t list;  (** one for each check; something is proved *)
}

type end_ =
  | Proved of t
  | None_found of string  (** why, for a person *)

val initial : Semantics.t -> State.t -> State.t
(** Of a declared state that no law of motion steers (a bug otherwise). *)

val attempt :
  Joint_check.options -> Semantics.t -> Uncertain.t -> declared:State.t -> Property.check list ->
  (end_, Start.fault) result
(** Of all starts, or an error if the declared state is not well-formed for some. *)

val prove :
  Joint_check.options -> Semantics.t -> Uncertain.t -> declared:State.t -> Property.check list ->
  (Property.check -> Verdict.outcome option) * end_
(** Of an ordinary model: what an invariant decides of some checks, before anything is explored. *)

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
  | Given_up of string  (** likewise: more work might find one *)

(** How much work is done ({!Scc_polyhedra.Effort}), for each state that the bounds allow, or for 200 000 if they
    allow fewer; and how many kinds of states there may be. *)
type effort =
  | Briefly  (** 50, about a second: before anything is explored, in half of the seconds that are left *)
  | Longer  (** 1000: of those who asked for an invariant, where exploring has not decided all *)
  | Unasked  (** 250, and 200 kinds of states: of others *)

val initial : Semantics.t -> State.t -> State.t
(** Of a declared state that no law of motion steers (a bug otherwise). *)

val attempt :
  Joint_check.options -> effort -> Semantics.t -> Uncertain.t -> declared:State.t -> Property.check list ->
  (end_, Start.fault) result
(** Of all starts, or an error if the declared state is not well-formed for some. *)

val leaving_time : Joint_check.options -> end_ option -> Joint_check.options
(** For what is explored after a search that ended so, and before a longer one: half of the seconds that are left,
    if there will be one. *)

val decide :
  Joint_check.options -> effort -> Semantics.t -> Uncertain.t -> declared:State.t -> Property.check list ->
  (Property.check -> Verdict.outcome option) * end_
(** Of an ordinary model: what an invariant decides of some checks. *)

(** Verdicts by invariants (rule Invariants). An invariant is searched for, and its consequences for some
    checks are computed. All of this is verified independently ({!Scc_certificate.Certificate}) before it
    counts. *)

open Scc_calculus
open Scc_semantics
open Scc_property
open Scc_symbolic

type t = {
  invariant : Scc_certificate.Invariant.t;
  proofs : Proof.t list;  (** one for each check; something is proved *)
}

type end_ =
  | Proved of t
  | None_found of string  (** the reason, for readers *)
  | Given_up of string  (** the reason, for readers: more work might find one *)

(** The work that is permitted ({!Scc_polyhedra.Effort}), for each state that the bounds allow, or for 200 000
    if they allow fewer; and the number of kinds of states. *)
type effort =
  | Briefly  (** 50, about a second: before anything is explored, in half of the seconds that are left *)
  | Longer  (** 1000: if an invariant was requested, and exploration has not decided all *)
  | Unasked  (** 250, and 200 kinds of states: if none was requested *)

val initial : Semantics.t -> State.t -> State.t
(** The initial state of a declared state that no law of motion steers (a bug otherwise). *)

val attempt :
  Setup.t -> effort -> Semantics.t -> Uncertain.t -> declared:State.t -> Property.check list ->
  (end_, Start.fault) result
(** The result of the search for an invariant of all starts. It is an error if the declared state is not
    well-formed for some values. *)

val leaving_time : Setup.t -> end_ option -> Setup.t
(** The options for an exploration after a search with this result. If a longer search will follow, the
    exploration has half of the seconds that are left. *)

val decide :
  Setup.t -> effort -> Semantics.t -> Uncertain.t -> declared:State.t -> Property.check list ->
  (Property.check -> Verdict.outcome option) * end_
(** The outcomes that an invariant decides for an ordinary model, and the result of the search. A declared
    state that is not well-formed gives [None_found]. *)

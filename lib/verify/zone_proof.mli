(** Verdicts by invariants (rule Invariants): an invariant is looked for, what it proves of some checks is found, and all
    of this is checked afresh ({!Scc_certificate.Certificate}) before it counts. *)

open Scc_polyhedra
open Scc_calculus
open Scc_semantics
open Scc_property
open Scc_symbolic

type t = {
  invariant : Invariant.t;
  proofs : Proof.t list;  (** one for each check *)
}

type end_ =
  | Proved of t  (** what it proves may be nothing *)
  | None_found of string  (** why, for a person *)

val attempt :
  Joint_check.options -> Semantics.t -> Uncertain.t -> declared:State.t -> parameters:Polyhedron.t -> Zone.t list ->
  Property.temporal list -> end_
(** From the zones of all starts, which do not keep time. *)

(** The exploration of the sets of states of a model whose parameters have ranges (rule Zones), for checks that are
    decided on one graph. *)

open Scc_calculus
open Scc_state_sets
open Scc_symbolic
open Scc_verify

type t = {
  group : Zone_groups.t;
  graph : Zone_graph.t;
  answers : Answers.t list;  (** of the members *)
  met : Answers.t list;  (** of the premises *)
  uneventful : bool;  (** all is known, and nothing ever happens *)
  stopped_by : Verdict.truncation list;  (** the bounds that were met *)
  unevaluated : Verdict.truncation option;
  (** the bound that ended the last evaluation of the formulas that no search decides, if one did *)
  fault : string option;  (** the reason why successors of a zone are not affine, or not known, if so *)
  decided : bool;  (** the exploration ended because every member was known *)
  edges : int;  (** of the graph *)
  proof : By_invariant.end_ option;  (** the end of the search for an invariant, if there was one *)
}

val explore :
  Setup.t ->
  Instant.context ->
  Zone_groups.t ->
  initial:State.t ->
  Zone.t list ->
  ranges:Ranges.t ->
  exactly:bool ->
  proof:By_invariant.end_ option ->
  t
(** Explores the group from these zones, up to the bounds of the options and of time in the formulas, or until all
    members are known. With [exactly] a member is known if its outcome is known for all values. Otherwise it is
    enough that it holds for all values or fails for some. [proof] is the result of an earlier search for an
    invariant; what it proves counts as known. *)

val proofs_of : Answers.t list -> By_invariant.end_ option -> Proof.t option list
(** [proofs_of answers end_] has the proof for each member, or [None] for each if no invariant was found. *)

val sets : Answers.t -> Proof.t option -> Answers.sets
(** [sets answer proof] has the values for which a formula holds, and those for which it fails, by the exploration
    or by the proof. It is a bug if the two contradict each other. *)

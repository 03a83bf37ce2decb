(** The exploration of the sets of states of a model whose parameters have ranges (rule Zones), for checks that are
    decided on one graph. *)

open Scc_property
open Scc_calculus
open Scc_symbolic

(** Checks and premises on one graph, each with its number among all of the model. *)
type group = Zone_groups.t = {
  keeps_time : bool;  (** zones tell absolute times apart *)
  part : State.t option;  (** the slice of the declared state that the group is about; all of it if [None] *)
  members : (int * Property.check) list;
  premises : (int * Property.check) list;
}

type t = {
  group : group;
  graph : Zone_graph.t;
  answers : Answers.t list;  (** of the members *)
  met : Answers.t list;  (** of the premises *)
  uneventful : bool;  (** all is known, and nothing ever happens *)
  stopped_by : Verdict.truncation list;  (** the bounds that were met *)
  fault : string option;  (** why numbers stopped being affine in the parameters, if they did *)
  decided : bool;  (** the exploration ended since every check was decided *)
  edges : int;  (** of the graph *)
  proof : Zone_proof.end_ option;  (** the end of the search for an invariant, if there was one *)
}

val explore :
  Joint_check.options ->
  Instant.context ->
  group ->
  initial:State.t ->
  Zone.t list ->
  ranges:Ranges.t ->
  exactly:bool ->
  proof:Zone_proof.end_ option ->
  t
(** Explores from these zones, up to the bounds of the options, the bounds of time of the formulas, and until all
    members are known. With [exactly] a member is known if it is for all values; without, if it fails for some or
    holds for all. [proof] is what is known beforehand. *)

val proofs_of : Answers.t list -> Zone_proof.end_ option -> Proof.t option list
(** The proof for each member, if the search for an invariant has one. *)

val sets : Answers.t -> Proof.t option -> Answers.sets
(** The values for which a formula holds and those for which it fails, by the exploration and by a proof. It is a
    bug if the two contradict each other. *)

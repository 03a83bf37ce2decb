(** The runs of a document. *)

open Scc_exact
open Scc_calculus
open Scc_semantics
open Scc_explain
open Scc_json

(** The check that a run illustrates. *)
type about = {
  formula : string;
  verdict : string;  (** ["holds"], ["violated"], … *)
  text : string;  (** the verdict in full *)
}

(** A transition that was taken. *)
type step = {
  choice : int option;  (** its number among the successors; [None] for a passing of time in part *)
  label : Transition.label;
  rules : Rule.t list;
  after : State.t;
}

val none : name:string -> about -> Json.t
(** A check whose verdict no single run shows. *)

val of_witness : States.t -> States.world -> most:int -> name:string -> about option -> Witness.t -> Json.t
(** A run that is the witness of a check. Its states get their transitions, as by {!Graph.expand} with
    [most]. *)

val of_steps :
  States.t ->
  States.world ->
  most:int ->
  name:string ->
  about option ->
  initial:State.t ->
  step list ->
  offset:Rat.t ->
  finish:string ->
  ending:string list ->
  Json.t
(** A run that was made by choices, and ends [offset] after its last transition. Its states get their
    transitions, as by {!Graph.expand} with [most]. *)

(** The runs of a document. *)

open Scc_exact
open Scc_calculus
open Scc_semantics
open Scc_explain
open Scc_exchange

(** What a run is shown for. *)
type about = {
  formula : string;
  verdict : string;  (** ["holds"], ["violated"], … *)
  text : string;  (** the verdict in full *)
}

(** A transition that was taken. *)
type step = {
  choice : int option;  (** which it was of those that were possible; of a passing of time in part none *)
  label : Transition.label;
  rules : Rule.t list;
  after : State.t;
}

val none : name:string -> about -> Json.t
(** For a check of which no single run shows the verdict. *)

(** In the states of a run it is told what was possible, as by {!Graph.expand} with [most]. *)

val of_witness : States.t -> States.world -> most:int -> name:string -> about option -> Witness.t -> Json.t

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
(** A run that was made by choices, and left [offset] after its last transition. *)

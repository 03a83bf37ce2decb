(** A semantics: a model, with how bodies move in it and who answers for geometry and neighbours. What all other
    rules are given. *)

open Scc_calculus

type t = private { setting : Kinematics.setting; kinematics : (module Kinematics.S); memo : Memo.t }

val make :
  ?geometry:Geometry.t ->
  ?neighbours:Kinematics.neighbours ->
  ?laws:Kinematics.laws ->
  ?memo:Memo.t ->
  Model.t -> t
(** Its kinematics is chosen here, once and for all: {!Turning} for rigid models (reading I-18), {!Straight} for
    others. Left to itself, each question about contact and each law is answered afresh, and all pairs are looked
    at. *)

val without_memo : t -> t
(** The same without a cache of processes ({!Memo.none}), for callers that keep such answers themselves. *)

val model : t -> Model.t

val with_model : t -> Model.t -> t
(** The same for another model over the same solids. *)

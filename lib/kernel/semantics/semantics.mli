(** A semantics: a model with its kinematics, and with implementations of geometry, neighbours, laws and caches.
    All rules take one. *)

open Scc_calculus

type t = private { setting : Kinematics.setting; kinematics : (module Kinematics.S); memo : Memo.t }

val make :
  ?geometry:Geometry.t ->
  ?neighbours:Kinematics.neighbours ->
  ?laws:Kinematics.laws ->
  ?memo:Memo.t ->
  Model.t -> t
(** [make m] is the semantics of [m]. Its kinematics is {!Turning} for rigid models (reading I-18), and
    {!Straight} for others. By default there are no caches: the geometry is {!Geometry.exact} with an obstacle
    for each query, each law is evaluated each time, and all pairs of parts are compared. *)

val without_memo : t -> t
(** [without_memo c] is [c] with {!Memo.none} in place of its cache, for callers that cache these queries
    themselves. *)

val model : t -> Model.t
(** The model of a semantics. *)

val with_model : t -> Model.t -> t
(** [with_model c m] is [c] for another model over the same solids, with an empty cache. Geometry, neighbours and
    laws are those of [c]. *)

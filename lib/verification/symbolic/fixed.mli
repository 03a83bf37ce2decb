(** A model whose parameters are not known, with values for them: an ordinary model. *)

open Scc_exact
open Scc_calculus

val behaviour : Model.t -> Rat.t array -> Behaviour.t -> Behaviour.t
(** With delays that are known, in canonical form: names stand for definitions of {!model} for the same values. *)

val has_open_offsets : Model.t -> bool
(** Whether the place of some part in its leaf depends on parameters that have ranges. *)

val offsets : Model.t -> Rat.t array -> Model.t
(** With those places for these values, and all else as it was. *)

val model : Model.t -> Rat.t array -> Model.t
(** Without ranges; its delays, and the places of parts in their leaves, are known. *)

val declared : Model.t -> Uncertain.t -> State.t -> Rat.t array -> State.t
(** [declared m u s values]: the declared state for the values, where [s] is it for others. *)

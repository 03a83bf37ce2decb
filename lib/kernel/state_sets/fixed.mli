(** The ordinary model that a model with ranges is for given values of its parameters. *)

open Scc_exact
open Scc_calculus

val behaviour : Model.t -> Rat.t array -> Behaviour.t -> Behaviour.t
(** [behaviour m values b] is [b] with known delays, in canonical form. Names are those of definitions of
    {!model} for the same values. *)

val has_open_offsets : Model.t -> bool
(** [has_open_offsets m] is true if the place of some part in its leaf depends on parameters that have
    ranges. *)

val offsets : Model.t -> Rat.t array -> Model.t
(** [offsets m values] is the model with the places of parts in their leaves for these values, and otherwise
    unchanged. *)

val model : Model.t -> Rat.t array -> Model.t
(** [model m values] is the model without ranges; its delays, and the places of parts in their leaves, are
    known. *)

val declared : Model.t -> Uncertain.t -> State.t -> Rat.t array -> State.t
(** [declared m u s values] is the declared state for the values, where [s] is that for other values. *)

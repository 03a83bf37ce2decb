(** States of one kind, those of a location of an invariant, over as few variables as they need. Certificates
    are checked on them. This module gives single states of a set; the motion of sets is not defined here. *)

open Scc_exact
open Scc_polyhedra
open Scc_calculus
open Scc_state_sets

type t = Zone.t
(** Its variables are of no meaning by themselves; its set is full-dimensional. *)

val of_location : Model.t -> Invariant.location -> t
(** The states of a location over as few variables as they need, so that the set is full-dimensional. *)

val on : t -> Polyhedron.t -> t option
(** [on z region] are the states of [z] on a region, over fewer variables if the region has a smaller
    dimension. [None] if the region is empty. *)

val points : Polyhedron.t -> Rat.t array list
(** Points of a full-dimensional polyhedron, one more than it has dimensions, that are in no hyperplane
    together. Forms that agree on them are the same. The first point is in the interior. The list is empty for
    an empty polyhedron. *)

val tidied : Behaviour.definitions -> Behaviour.aged -> Behaviour.aged
(** One term for all that differ in nil, in equal summands, and in names that stand for their bodies. They are
    the same behaviour (readings I-14 and I-17). A delay that turns out to have length 0 makes such a
    difference. *)

val tidy : Behaviour.definitions -> State.t -> State.t
(** The state with each behaviour {!tidied}, and without time. *)

val state : Model.t -> t -> Rat.t array -> State.t
(** [state m z point] is a single state, of the ordinary model for the values of its parameters
    ({!Scc_state_sets.Fixed.model}). Its behaviours have aged. *)

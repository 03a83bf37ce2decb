(** States of one kind, as a location of an invariant has them, by as few variables as they need: what a
    certificate is checked on. It knows what single states of it are, and nothing of how sets of states move. *)

open Scc_exact
open Scc_polyhedra
open Scc_calculus
open Scc_symbolic

type t = Zone.t
(** Its variables are of no meaning by themselves; its set is full-dimensional. *)

val of_location : Model.t -> Invariant.location -> t
val on : t -> Polyhedron.t -> t option
(** The states of it on a region: over fewer variables, where the region is thinner. [None] where it has none. *)

val points : Polyhedron.t -> Rat.t array list
(** Points of a full-dimensional polyhedron, one more than it has dimensions, that are in no plane together: forms
    that agree on them are the same. The first one is in its interior. *)

val tidied : Behaviour.definitions -> Behaviour.aged -> Behaviour.aged
(** One term for all that differ in nil, in equal summands, and in names that stand for their bodies: they are the
    same behaviour (readings I-14 and I-17), and a delay that turns out to have no length makes such a difference.
*)

val tidy : Behaviour.definitions -> State.t -> State.t
(** With all behaviours so, and without time. *)

val state : Model.t -> t -> Rat.t array -> State.t
(** A single state, of the ordinary model that there is for the values of its parameters
    ({!Scc_symbolic.Fixed.model}): with behaviours as they have become. *)

(** State predicates along a time transition, exactly and at all of its instants (rule Instants).
    Coordinates are affine in the offset t since the start, squared distances quadratic, contact a closed
    interval for each pair of parts. *)

open Scc_ctl
open Scc_calculus
open Scc_semantics
open Scc_property

type t

val make : ?arrived:(Property.event -> bool) -> Semantics.t -> State.t -> Timeline.extent -> t
(** The trajectory that starts in a state: of a time transition of the given duration, the ray [0,
    infinity) of a quiescent state, or just the state itself. Nothing happens strictly inside it, and the
    end is not part of it (it is the state that the transition leads to). [arrived] tells of which events
    the discrete transition was that has just led to the state (by default of none, as in the initial
    state): they hold at the start alone. *)

val extent : Semantics.t -> State.t -> Transition.t list -> Timeline.extent
(** How long nothing happens from a state on, of which these are all transitions: for ever also where bonds may be
    released at any of the instants that are looked at, and nothing else is ahead. *)

val predicate : Semantics.t -> Property.prop -> t -> Truth.t Timeline.t
(** Where the predicate holds, of a trajectory of the model; prepared when it is given. Undecided at instants where
    it divides by zero. *)

val prop : t -> Property.prop -> Truth.t Timeline.t
(** The same at once. *)

val num : t -> Property.num -> Value.t Timeline.t

val number_at : t -> Property.num -> Scc_exact.Rat.t -> (Scc_exact.Rat.t, string) result
(** At an offset of it; or why there is none. *)

val holds : Semantics.t -> State.t -> Property.prop -> Truth.t
(** Whether a predicate holds in a state (at the instant of it). *)

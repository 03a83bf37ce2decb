(** State predicates along a time transition, at all of its instants (rule Instants). In the translational
    calculus they are exact. There, coordinates are affine in the offset t since the start, squared distances are
    quadratic, and contact is a closed interval for each pair of parts. In the rigid calculus, {!Scc_motion.Path}
    and {!Near} give coordinates and contact. *)

open Scc_ctl
open Scc_calculus
open Scc_semantics
open Scc_property

type t

val make :
  ?arrived:(Property.event -> bool) ->
  ?total:(Property.quantity -> int option) ->
  Semantics.t ->
  State.t ->
  Timeline.extent ->
  t
(** [make semantics s extent] is the trajectory of this extent that starts in [s]. It is that of a time
    transition of the given duration, the ray t >= 0 of a quiescent state, or the state alone. Nothing happens
    strictly inside it. Its end is not part of it, but is the state that the transition leads to. [arrived] is
    true for the events of the discrete transition that has just led to [s]; these hold at the start alone. By
    default there are none, as in the initial state. [total] is the values of the sums over all processes that are
    known ({!Atom.t.total}); [s] need not have all processes for these. The others are counted in [s]. *)

val extent : Semantics.t -> State.t -> Transition.t list -> Timeline.extent
(** [extent semantics s transitions] is how long nothing happens from [s] on, where [transitions] are all
    transitions of [s]. It is for ever if [s] is quiescent. It is for ever, too, if all transitions are weak
    splits: then bonds may be released at any instant, and nothing else is ahead. *)

val predicate : Semantics.t -> Property.prop -> t -> Truth.t Timeline.t
(** [predicate semantics p trajectory] is the truth of [p] along [trajectory]. Applied to [semantics] and [p]
    alone, it does all work that does not depend on the trajectory. The truth is undecided at instants where [p]
    divides by zero. *)

val prop : t -> Property.prop -> Truth.t Timeline.t
(** [prop trajectory p] is the truth of [p] along [trajectory]: {!predicate} for a single use. *)

val num : t -> Property.num -> Value.t Timeline.t
(** [num trajectory n] is the value of [n] along [trajectory]. *)

val number_at : t -> Property.num -> Scc_exact.Rat.t -> (Scc_exact.Rat.t, string) result
(** [number_at trajectory n offset] is the value of [n] at an offset of [trajectory], or why it is undefined. *)

val holds : Semantics.t -> State.t -> Property.prop -> Truth.t
(** [holds semantics s p] is the truth of [p] in the state [s], at its instant. Events count as not arrived. *)

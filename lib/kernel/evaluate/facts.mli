(** Why a predicate holds or fails at an instant, in words. *)

open Scc_ctl
open Scc_exact
open Scc_calculus
open Scc_semantics
open Scc_property

val at :
  ?arrived:(Property.event -> bool) ->
  ?later_than:Rat.t ->
  ?known:(Property.quantity -> bool) ->
  Semantics.t -> State.t -> Timeline.extent -> Algebraic.t -> Property.prop -> string list
(** [at semantics state extent offset p]: for each atom of [p], whether it holds at that offset of the
    trajectory from the state, with the values of what it compares: ["x(p) <= 3 fails: x(p) = 25/8"].
    [arrived] is that of {!Trajectory.make}. [later_than]: the time of the state stands for all times after this
    one, so that no other is told. The values of quantities that are not [known] are not told either: the state
    stands for others, with other values, of which the same holds. *)

val every : Trajectory.t -> Model.t -> Algebraic.t -> Property.prop -> string list
(** The same for all atoms, however many, at an offset of a trajectory. *)

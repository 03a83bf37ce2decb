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
(** [at semantics state extent offset p] is a sentence for each atom of [p], for at most 16 atoms. It states if
    the atom holds at that offset of the trajectory from the state. It has the values of what the atom compares:
    ["x(p) <= 3 fails: x(p) = 25/8"]. [arrived] is that of {!Trajectory.make}. With [later_than], the time of the
    state stands for all times after this one, and the sentences state this bound in place of values that change
    with time. Values of quantities that are not [known] are left out: the state stands for others with different
    values. *)

val every : Trajectory.t -> Model.t -> Algebraic.t -> Property.prop -> string list
(** [every trajectory m offset p] is a sentence as in {!at} for each atom of [p], without a limit on their
    number, at an offset of a trajectory. *)

(** From which time on a formula has one truth, whatever happens, and how far formulas look therefore
    (rule Settling). Times are absolute: those of the atom [time]. *)

open Scc_exact
open Scc_calculus

type t = { after : Rat.t; truth : bool }
(** A formula has this truth at every position whose time is greater than [after], which is 0 or more. *)

val prop : Model.t -> Property.prop -> t option
(** The truth on which a predicate settles; [None] if none is known. It is known of comparisons in which [time]
    outgrows the rest, as [time > 2] or [2 * time <= processes], and of what is joined of these. *)

val temporal : Model.t -> Property.temporal -> t option
(** The truth on which a formula settles; [None] if none is known. *)

val last_goals : Model.t -> Property.temporal -> Rat.t list
(** For each operator U in a formula whose right side settles on false, the time after which it is false. F and G
    count as U. *)

val of_checks : Model.t -> from:Rat.t -> Property.check list -> Rat.t option
(** [of_checks m ~from checks] is a time such that the answers in a state at the time [from] do not depend on later
    positions; [None] if no such time is known, as with X, whose next event may be however late. *)

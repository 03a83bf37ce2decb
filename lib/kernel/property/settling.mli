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

type reach = { time : Rat.t; events : int }
(** The positions up to [time], and those that follow them by at most so many discrete transitions after that
    time. *)

val latest : reach option list -> reach option
(** The union of what several formulas depend on; [None] if one of them has no bound. *)

val of_formula : Model.t -> from:Rat.t -> Property.temporal -> reach option
(** [of_formula m ~from f] is the positions that the truth of [f] in a state at the time [from] depends on; [None]
    if there is no such bound. *)

val of_check : Model.t -> from:Rat.t -> Property.check -> reach option
(** [of_check m ~from c] is the positions that the answer to [c] in a state at the time [from] depends on, as
    in {!of_formula}. *)

val of_checks : Model.t -> from:Rat.t -> Property.check list -> reach option
(** The positions that the answers to several checks depend on ({!of_check}); [None] if one of them has no such
    bound. *)

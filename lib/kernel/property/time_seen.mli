(** Which absolute times the atoms of a formula tell apart (rule AbsoluteTime). *)

open Scc_exact
open Scc_calculus

type t =
  | Never  (** it does not depend on absolute time *)
  | Until of Rat.t
  (** it compares time with what stays within bounds: constants, numbers of bodies and bonds, choices among these.
      After this time, 0 or more, no such comparison changes any more, so all later times are equivalent *)
  | Always  (** it compares time with what may grow as fast as time, or computes with it *)

val num : Model.t -> Property.num -> t
(** The times that a number tells apart: [Always] if its value itself changes with time. Conditions within it may
    tell fewer apart. *)

val formula : Model.t -> Property.temporal -> t
(** The times that the state predicates of a formula tell apart. *)

val checks : Model.t -> Property.check list -> t
(** The times that some checks tell apart: their formulas, and the numbers of which they take the mean. *)

val law : Model.t -> Law.t -> t
(** The times that a law of motion tells apart. All other variables of laws count as unbounded. *)

val join : t -> t -> t
(** The union of what two tell apart: the least upper bound in the order [Never], [Until] by times, [Always]. *)

val same_kind : t -> t -> bool
(** [same_kind a b] is true if [a] and [b] have the same constructor, whatever the time in it. *)

val beyond : t -> Rat.t -> Rat.t option
(** [beyond seen time] is the time of [Until], if [time] is later; else [None]. *)

val representative : t -> Rat.t -> Rat.t
(** [representative seen time] is the one time that stands for all times equivalent to [time]. It is 0 for
    [Never], 1 after the bound of [Until] for all times beyond it, and [time] itself otherwise. *)

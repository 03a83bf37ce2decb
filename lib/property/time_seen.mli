(** How much of the absolute time a formula can see (rule AbsoluteTime): which times its atoms tell apart. *)

open Scc_exact

type t =
  | Never  (** it does not speak of time *)
  | Until of Rat.t
  (** it compares time with constants, of which this is the greatest, and 0 at least: the times after it are all
      the same to it *)
  | Always  (** it compares time with what changes, or computes with it *)

val num : Property.num -> t
(** [Always] when the value itself changes with time; conditions within it may see less. *)

val formula : Property.temporal -> t

val formulas : Property.temporal list -> t
(** All that some of them see. *)

val same_kind : t -> t -> bool
(** Up to the constant. *)

val beyond : t -> Rat.t -> Rat.t option
(** The greatest constant, when the time is later. *)

val representative : t -> Rat.t -> Rat.t
(** The time that stands for all that are the same as this one, to what sees so much: {!beyond} does not tell it
    from them. *)

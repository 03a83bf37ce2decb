(** How much of the absolute time a formula can see (rule AbsoluteTime): which times its atoms tell apart. *)

open Scc_exact
open Scc_calculus

type t =
  | Never  (** it does not speak of time *)
  | Until of Rat.t
  (** it compares time with what stays within bounds: constants, numbers of bodies and bonds, choices among these.
      After this time, 0 at least, no such comparison changes any more, so that all later times are the same to it
  *)
  | Always  (** it compares time with what may get as great as time, or computes with it *)

val num : Model.t -> Property.num -> t
(** [Always] when the value itself changes with time; conditions within it may see less. *)

val formula : Model.t -> Property.temporal -> t

val checks : Model.t -> Property.check list -> t
(** All that some of them see, with the numbers whose means they ask for. *)

val law : Model.t -> Law.t -> t
(** The same of a law of motion. *)

val join : t -> t -> t

val same_kind : t -> t -> bool
(** Up to the constant. *)

val beyond : t -> Rat.t -> Rat.t option
(** The greatest constant, when the time is later. *)

val representative : t -> Rat.t -> Rat.t
(** The time that stands for all that are the same as this one, to what sees so much: {!beyond} does not tell it
    from them. *)

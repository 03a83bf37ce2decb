(** A parameter with a range, as it is in one run. *)

open Scc_base
open Scc_exact
open Scc_calculus

type t =
  | Known of Rat.t  (** it has a value from outside, or a range of one number *)
  | In of Ranges.range  (** a range of more than one number *)

val range : Report.t -> Span.t -> Ranges.range -> Overrides.given option -> t option
(** [range report at declared given] is the declared range, which stands at [at], with the value or range from
    outside. An empty range is SC0217, and so is a value or range outside the declared one; the result is then
    [None]. *)

(** What a parameter with a range is in this run. *)

open Scc_base
open Scc_exact
open Scc_calculus

type t =
  | Known of Rat.t  (** given a value, or of a range of one number *)
  | In of Ranges.range  (** of more than one *)

val range : Report.t -> Span.t -> Ranges.range -> Overrides.given option -> t option
(** Of the declared range, at this place, and what was given from outside. [None] when a range has no numbers, or
    what was given is not within the declared one, which is reported (SC0217). *)
